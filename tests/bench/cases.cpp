// SPDX-License-Identifier: MIT
#include "tests/bench/cases.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <iomanip>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "tests/bench/openrt_engine.h"
#include "tests/support/procedural_meshes.h"

namespace smart::bench {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr uint32_t kMesh = 20'000; // triangles

using Mesh = std::shared_ptr<const std::vector<Triangle>>;

struct Case {
    std::string name;
    Mesh triangles;
    std::vector<Ray> rays;
    std::size_t perCall = 1024;
};

std::vector<Ray> camera(test::CameraPose pose, uint32_t size) {
    return test::cameraRays(pose, size, size);
}

std::vector<Ray> aimed(const double (&eye)[3], std::size_t count, uint64_t seed) {
    test::Random random(seed);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const std::array<double, 3> d = random.onSphere();
        rays.push_back({{float(eye[0]), float(eye[1]), float(eye[2])},
                        {float(d[0]), float(d[1]), float(d[2])},
                        0,
                        kInfinity});
    }
    return rays;
}

/// Origins all over the unit cube's surroundings, directions anywhere.
std::vector<Ray> diverging(std::size_t count, uint64_t seed) {
    test::Random random(seed);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        Ray ray{{}, {}, 0, kInfinity};
        const std::array<double, 3> d = random.onSphere();
        for (int k = 0; k < 3; ++k) {
            ray.org[k] = float(random.between(-2, 2));
            ray.dir[k] = float(d[std::size_t(k)]);
        }
        rays.push_back(ray);
    }
    return rays;
}

/// The pixels of a camera's square picture column by column.
std::vector<Ray> columns(const std::vector<Ray>& blocks, uint32_t size) {
    std::vector<Ray> rays;
    for (uint32_t x = 0; x < size; ++x) {
        for (uint32_t y = 0; y < size; ++y)
            rays.push_back(blocks[(y / 4 * (size / 4) + x / 4) * 16 + y % 4 * 4 + x % 4]);
    }
    return rays;
}

std::vector<Ray> turnedAway(std::vector<Ray> rays) {
    for (Ray& ray : rays)
        for (float& d : ray.dir) d = -d;
    return rays;
}

/// Parallel rays from a grid, blocks of 4x4 adjacent.
std::vector<Ray> parallel(uint32_t size) {
    std::vector<Ray> rays;
    for (uint32_t block = 0; block < size / 4 * (size / 4); ++block) {
        for (uint32_t i = 0; i < 16; ++i) {
            const double x = 2.0 * (block % (size / 4) * 4 + i % 4 + 0.5) / size - 1,
                         y = 2.0 * (block / (size / 4) * 4 + i / 4 + 0.5) / size - 1;
            rays.push_back({{float(x), float(y), 3}, {0, 0, -1}, 0, kInfinity});
        }
    }
    return rays;
}

/// Above the hills, level with them: through the box of the mesh, and past all triangles.
std::vector<Ray> aboveHills(uint32_t size) {
    std::vector<Ray> rays = parallel(size);
    for (Ray& ray : rays) ray.org[1] = 0.255f + 0.02f * ray.org[1];
    return rays;
}

std::vector<Case> cases(uint32_t size) {
    const auto mesh = [](std::vector<Triangle> triangles) {
        return std::make_shared<const std::vector<Triangle>>(std::move(triangles));
    };
    const Mesh sphere = mesh(test::bumpySphere(kMesh)), hills = mesh(test::heightfield(kMesh)),
               room = mesh(test::closedRoom()),
               one = mesh({Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}}), none = mesh({});
    const std::size_t count = std::size_t(size) * size;
    const uint32_t small = std::max(4u, size / 8 * 4);
    const test::CameraPose outside{{0.4, 0.7, 2.6}, {0, 0, 0}, {0, 1, 0}, 45};
    const test::CameraPose inside{{0, 0, 0}, {0.3, 0.2, 1}, {0, 1, 0}, 60};
    test::CameraPose close = outside; // at one triangle
    close.fov = 0.01;
    const test::CameraPose horizon{{0, 0.3, 0.9}, {0, 0.25, -1}, {0, 1, 0}, 100};
    const float* const vertex = (*sphere)[1000].v0;
    const test::CameraPose onVertex{
        {vertex[0], vertex[1], vertex[2]}, {0, 0, 0}, {0, 1, 0}, 60};
    const test::CameraPose onPlane{{4, 0.3, 0.7}, {4, 0.1, -3}, {0, 1, 0}, 60};
    std::vector<Case> all;
    all.push_back({"camera, for comparison", sphere, camera(outside, size)});
    all.push_back({"diverge wholly", sphere, diverging(count, 1)});
    all.push_back({"diverge from one point", sphere, aimed({0, 0, 0}, count, 2)});
    all.push_back({"all miss, turned away", sphere, turnedAway(camera(outside, size))});
    all.push_back({"all miss, through the box", hills, aboveHills(size)});
    all.push_back({"all hit one triangle of many", sphere, camera(close, size)});
    all.push_back({"origins inside", sphere, camera(inside, size)});
    all.push_back({"across the horizon", hills, camera(horizon, size)});
    all.push_back({"eye on a vertex", sphere, camera(onVertex, size)});
    all.push_back({"eye on a plane", room, camera(onPlane, size)});
    all.push_back({"parallel, along an axis", sphere, parallel(size)});
    all.push_back({"one triangle", one, camera(outside, size)});
    all.push_back({"no triangle", none, camera(outside, size)});
    all.push_back({"picture of 1x1", sphere, camera(outside, small), 1});
    all.push_back({"picture of 1x4", sphere, camera(outside, small), 4});
    all.push_back({"picture of one column", sphere, columns(camera(outside, size), size), size});
    all.push_back({"picture of 4x4", sphere, camera(outside, small), 16});
    all.push_back({"picture of 1x4, diverging", sphere, diverging(count / 4, 3), 4});
    all.push_back({"picture of 4x4, diverging", sphere, diverging(count / 4, 4), 16});
    return all;
}

/// What a form answers: t and the triangle of each ray, or 0 and 1 in `triangle` for any hit.
struct CaseAnswers {
    std::vector<float> t;
    std::vector<uint32_t> triangle;
};

/// One case with its rays in all forms.
class CaseRun {
public:
    CaseRun(const Case& one, const ScenePtr& scene) : case_(one), scene_(scene) {
        for (const Ray& ray : one.rays) {
            for (int k = 0; k < 3; ++k) {
                org_[k].push_back(ray.org[k]);
                dir_[k].push_back(ray.dir[k]);
            }
            tFar_.push_back(ray.tFar);
        }
        for (std::size_t first = 0; first < one.rays.size(); first += one.perCall) {
            const std::size_t last = std::min(first + one.perCall, one.rays.size());
            calls_.push_back(packets_.size());
            for (std::size_t r = first; r < last; r += kPacketSize)
                packets_.push_back(test::packet(std::span(one.rays).first(last), r));
        }
        calls_.push_back(packets_.size());
    }

    void single(Query query, CaseAnswers& answers) const {
        Hit hit;
        for (std::size_t i = 0; i < case_.rays.size(); ++i) {
            if (query == Query::Closest) {
                kernels().intersect1[mode()](scene_->view(), case_.rays[i], hit);
                answers.t[i] = hit.t;
                answers.triangle[i] = hit.triangle;
            } else {
                answers.triangle[i] = kernels().occluded1[mode()](scene_->view(), case_.rays[i]);
            }
        }
    }
    void packet(Query query, CaseAnswers& answers) const {
        HitPacket hits;
        uint32_t blocked = 0;
        for (std::size_t p = 0, ray = 0; p < packets_.size(); ++p) {
            if (query == Query::Closest) {
                kernels().intersect[mode()](scene_->view(), packets_[p], hits);
                ray = keep(packets_[p], hits, ray, answers);
            } else {
                kernels().occluded[mode()](scene_->view(), packets_[p], blocked);
                ray = keep(packets_[p], blocked, ray, answers);
            }
        }
    }
    void tile(Query query, CaseAnswers& answers) const {
        HitPacket hits[kTilePackets];
        uint32_t blocked[kTilePackets];
        std::size_t ray = 0;
        for (std::size_t call = 0; call + 1 < calls_.size(); ++call) {
            for (std::size_t p = calls_[call]; p < calls_[call + 1]; p += kTilePackets) {
                const auto n =
                    uint32_t(std::min<std::size_t>(kTilePackets, calls_[call + 1] - p));
                if (query == Query::Closest)
                    kernels().intersectTile[mode()](scene_->view(), &packets_[p], n, hits);
                else
                    kernels().occludedTile[mode()](scene_->view(), &packets_[p], n, blocked);
                for (uint32_t i = 0; i < n; ++i)
                    ray = query == Query::Closest ? keep(packets_[p + i], hits[i], ray, answers)
                                                  : keep(packets_[p + i], blocked[i], ray, answers);
            }
        }
    }
    void asked(Query query, Coherence coherence, std::size_t perCall, CaseAnswers& answers) const {
        flags_.resize(case_.rays.size());
        for (std::size_t first = 0; first < case_.rays.size(); first += perCall) {
            const std::size_t count = std::min(perCall, case_.rays.size() - first);
            RayStream rays{};
            for (int k = 0; k < 3; ++k) {
                rays.org[k] = org_[k].data() + first;
                rays.dir[k] = dir_[k].data() + first;
            }
            rays.tFar = tFar_.data() + first;
            HitStream hits{};
            hits.t = answers.t.data() + first;
            hits.primitive = answers.triangle.data() + first;
            if (query == Query::Closest)
                intersect(*scene_, rays, hits, count, coherence);
            else
                occluded(*scene_, rays, flags_.data() + first, count, coherence);
        }
        if (query == Query::Any) std::copy(flags_.begin(), flags_.end(), answers.triangle.begin());
    }

private:
    int mode() const { return int(scene_->precision()); }
    static std::size_t keep(const RayPacket& packet, const HitPacket& hits, std::size_t ray,
                            CaseAnswers& answers) {
        for (int lane = 0; lane < kPacketSize && (packet.active >> lane & 1); ++lane, ++ray) {
            answers.t[ray] = hits.t[lane];
            answers.triangle[ray] = hits.triangle[lane];
        }
        return ray;
    }
    static std::size_t keep(const RayPacket& packet, uint32_t blocked, std::size_t ray,
                            CaseAnswers& answers) {
        for (int lane = 0; lane < kPacketSize && (packet.active >> lane & 1); ++lane, ++ray)
            answers.triangle[ray] = blocked >> lane & 1;
        return ray;
    }

    const Case& case_;
    const ScenePtr scene_;
    std::vector<float> org_[3], dir_[3], tFar_;
    std::vector<RayPacket> packets_;
    std::vector<std::size_t> calls_; ///< first packet of each
    mutable std::vector<uint8_t> flags_;
};

double processorSeconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// The yardstick of the kernels is the first form, that of the public query the one called alone.
CaseSeries measureCase(const Case& one, const ScenePtr& scene, Query query, unsigned repeats) {
    const CaseRun run(one, scene);
    struct Form {
        const char* name;
        std::function<void(CaseAnswers&)> trace;
        std::size_t yardstick;
    };
    const auto ask = [&](Coherence coherence, std::size_t perCall) {
        return [&run, query, coherence, perCall](CaseAnswers& answers) {
            run.asked(query, coherence, perCall, answers);
        };
    };
    std::vector<Form> forms = {
        {"single", [&](CaseAnswers& a) { run.single(query, a); }, 0},
        {"query, one a call", ask(Coherence::Incoherent, 1), 1},
        {"packet", [&](CaseAnswers& a) { run.packet(query, a); }, 0},
        {"tile", [&](CaseAnswers& a) { run.tile(query, a); }, 0},
        {"query coherent", ask(Coherence::Coherent, one.perCall), 1},
        {"query incoherent", ask(Coherence::Incoherent, one.perCall), 1}};
    if (scene->precision() == Precision::Precise) forms.erase(forms.begin() + 3);

    CaseSeries series{one.name, query, one.rays.size(), {}};
    std::vector<std::vector<double>> seconds(forms.size());
    std::vector<CaseAnswers> answers(forms.size());
    for (std::size_t f = 0; f < forms.size(); ++f) {
        series.results.push_back({forms[f].name, 0, 0, forms[f].yardstick != f, 0});
        answers[f].t.resize(one.rays.size());
        answers[f].triangle.resize(one.rays.size());
    }
    for (unsigned repeat = 0; repeat <= repeats; ++repeat) { // the first only warms caches
        for (std::size_t f = 0; f < forms.size(); ++f) {
            const double start = processorSeconds();
            forms[f].trace(answers[f]);
            if (repeat > 0) seconds[f].push_back(processorSeconds() - start);
        }
    }
    const Truth truth(*one.triangles);
    for (std::size_t f = 0; f < forms.size(); ++f) {
        std::vector<double> ratios;
        for (unsigned i = 0; i < repeats; ++i)
            ratios.push_back(seconds[f][i] / seconds[forms[f].yardstick][i]);
        series.results[f].nanoseconds = medianOf(seconds[f]) * 1e9 / double(one.rays.size());
        series.results[f].ofSingle = medianOf(ratios);
        for (std::size_t i = 0; i < one.rays.size(); ++i) {
            // Single rays are judged now and then, all others where they say something else.
            const bool same = answers[f].triangle[i] == answers[0].triangle[i];
            if (same && i % 97 != 0) continue;
            const Verdict verdict =
                query == Query::Closest
                    ? truth.closest(one.rays[i], answers[f].triangle[i], answers[f].t[i])
                    : truth.any(one.rays[i], answers[f].triangle[i] != 0);
            series.results[f].wrong += verdict == Verdict::Wrong;
        }
    }
    return series;
}

const char* nameOf(Query query) {
    return query == Query::Closest ? "closest" : "any";
}

} // namespace

std::vector<CaseSeries> measureCases(Precision precision, uint32_t size, unsigned repeats,
                                     const Progress& progress) {
    std::vector<CaseSeries> all;
    std::map<Mesh, ScenePtr> scenes;
    for (const Case& one : cases(size)) {
        progress(one.name);
        ScenePtr& scene = scenes[one.triangles];
        if (!scene) {
            BuildReport report;
            scene = buildOpenrt(*one.triangles, precision, 1, report);
        }
        for (const Query query : {Query::Closest, Query::Any})
            all.push_back(measureCase(one, scene, query, repeats));
    }
    return all;
}

nlohmann::json jsonOf(const std::vector<CaseSeries>& cases) {
    nlohmann::json result = nlohmann::json::array();
    for (const CaseSeries& series : cases) {
        nlohmann::json forms;
        for (const CaseResult& one : series.results)
            forms.push_back({{"form", one.form},
                             {"nanosecondsPerRay", one.nanoseconds},
                             {"ofSingle", one.ofSingle},
                             {"tooSlow", one.asked && one.ofSingle > kCaseLimit},
                             {"wrong", one.wrong}});
        result.push_back({{"case", series.name},
                          {"query", nameOf(series.query)},
                          {"rays", series.rays},
                          {"forms", forms}});
    }
    return result;
}

void print(std::ostream& out, const std::vector<CaseSeries>& cases) {
    out << std::fixed;
    std::size_t slow = 0, wrong = 0;
    for (const CaseSeries& series : cases) {
        out << series.name << ", " << nameOf(series.query) << '\n';
        for (const CaseResult& one : series.results) {
            const bool tooSlow = one.asked && one.ofSingle > kCaseLimit;
            slow += tooSlow;
            wrong += one.wrong;
            out << "  " << std::left << std::setw(20) << one.form << std::right
                << std::setprecision(1) << std::setw(9) << one.nanoseconds << " ns a ray, "
                << std::setprecision(2) << one.ofSingle << " of single rays"
                << (tooSlow ? ", too slow" : "");
            if (one.wrong) out << ", " << one.wrong << " wrong";
            out << '\n';
        }
    }
    out << slow << " too slow, " << wrong << " wrong\n";
}

} // namespace smart::bench
