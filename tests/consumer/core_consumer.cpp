// SPDX-License-Identifier: MIT
// A C++ program outside the project on the static core alone.
#include <cstdio>

#include "libsmart/geometry/model_builder.h"
#include "libsmart/scene/scene.h"

int main() {
    smart::ModelBuilder builder;
    builder.triangles.push_back({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    smart::Instance instance;
    instance.model = std::move(builder).build();
    const smart::Scene scene({instance}, smart::Precision::Watertight, 1);
    const smart::Ray ray{{0.25f, 0.25f, 1}, {0, 0, -1}, 0, 10};
    smart::Hit hit;
    smart::kernels().intersect1[int(smart::Precision::Watertight)](scene.view(), ray, hit);
    std::printf("%s: t = %g\n", smart::kernels().name, double(hit.t));
    return hit.triangle == 0 && hit.t == 1 ? 0 : 1;
}
