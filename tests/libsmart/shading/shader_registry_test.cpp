// SPDX-License-Identifier: MIT
#include "libsmart/shading/shader_registry.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/libsmart/shading/fake_tracer.h"
#include "openrt/shader.hpp"

namespace smart {
namespace {

using namespace openrt;
using test::bytesOf;

std::atomic<int> living{0};

struct Counted {
    Color color{0.5f};
    const char* text = "none";
    struct VertexParam {
        float heat = 1;
    };

    Counted() { ++living; }
    ~Counted() { --living; }
    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("color", PER_SHADER, offsetof(Counted, color));
        r.registerParam<const char*>("text", PER_SHADER, offsetof(Counted, text));
        r.registerParam<float>("heat", PER_VERTEX, offsetof(VertexParam, heat));
    }
    void shade(TraceContext& c) const { c.setRadiance(color); }
};

ShaderClassPtr countedClass() {
    return std::make_shared<ShaderClass>(*shaderClass<Counted>("Counted"), nullptr);
}

const Counted& blockOf(const ShaderObject& object) {
    return *static_cast<const Counted*>(object.block());
}

TEST(ShaderRegistryTest, TheDefaultSurfaceHasIndexZero) {
    ShaderRegistry registry;
    EXPECT_EQ(registry.defaultSurface()->index(), 0u);
    EXPECT_EQ(registry.defaultSurface()->shaderClass()->name(), "FixedFunction");
    const auto table = registry.freeze();
    ASSERT_EQ(table->size(), 1u);
    EXPECT_EQ((*table)[0]->shaderClass().kind(), RTenum(RT_SURFACE_SHADER));
}

TEST(ShaderRegistryTest, FrozenShadersDoNotChange) {
    ShaderRegistry registry;
    const auto shader = registry.create(countedClass());
    const auto before = registry.freeze();
    shader->set(0, bytesOf(Color(1, 2, 3)));
    EXPECT_EQ(blockOf(*(*before)[shader->index()]).color, Color(0.5f));
    const auto after = registry.freeze();
    EXPECT_EQ(blockOf(*(*before)[shader->index()]).color, Color(0.5f));
    EXPECT_EQ(blockOf(*(*after)[shader->index()]).color, Color(1, 2, 3));
}

TEST(ShaderRegistryTest, UnchangedShadersKeepTheirObjectsAndTheTable) {
    ShaderRegistry registry;
    const auto a = registry.create(countedClass()), b = registry.create(countedClass());
    a->set(0, bytesOf(Color(1, 2, 3)));
    const auto first = registry.freeze();
    EXPECT_EQ(registry.freeze(), first);
    a->set(0, bytesOf(Color(1, 2, 3))); // the same value
    EXPECT_EQ(registry.freeze(), first);
    b->set(0, bytesOf(Color(0.0f)));
    const auto second = registry.freeze();
    EXPECT_NE(second, first);
    EXPECT_EQ((*second)[a->index()], (*first)[a->index()]);
    EXPECT_NE((*second)[b->index()], (*first)[b->index()]);
}

/// Uses the registry while it is constructed and destroyed.
struct Reentrant {
    static inline ShaderRegistry* registry = nullptr;
    static inline std::shared_ptr<Shader> made;

    Reentrant() {
        if (registry) made = registry->create(countedClass());
    }
    ~Reentrant() { made.reset(); }
    void shade(TraceContext& c) const { c.setRadiance(Color(1.0f)); }
};

TEST(ShaderRegistryTest, ConstructorsAndDestructorsMayUseIt) {
    ShaderRegistry registry;
    auto shader = registry.create(
        std::make_shared<ShaderClass>(*shaderClass<Reentrant>("Reentrant"), nullptr));
    Reentrant::registry = &registry;
    EXPECT_NE((*registry.freeze())[shader->index()], nullptr);
    ASSERT_TRUE(Reentrant::made);
    const uint32_t made = Reentrant::made->index();
    EXPECT_NE((*registry.freeze())[made], nullptr) << "it came while the table was made";
    shader.reset();
    registry.freeze();
    EXPECT_FALSE(Reentrant::made) << "it left with the old table";
    EXPECT_EQ((*registry.freeze())[made], nullptr);
    Reentrant::registry = nullptr;
}

TEST(ShaderRegistryTest, RemovedShadersLeaveTheTableButNotFrozenOnes) {
    const int before = living;
    {
        ShaderRegistry registry;
        auto shader = registry.create(countedClass());
        const uint32_t index = shader->index();
        const auto first = registry.freeze();
        EXPECT_EQ(living, before + 1);
        shader.reset();
        const auto second = registry.freeze();
        EXPECT_EQ((*second)[index], nullptr);
        EXPECT_EQ(blockOf(*(*first)[index]).color, Color(0.5f));
    }
    EXPECT_EQ(living, before);
}

TEST(ShaderRegistryTest, IndicesOfRemovedShadersAreUsedAgain) {
    ShaderRegistry registry;
    const auto kept = registry.create(countedClass());
    auto removed = registry.create(countedClass());
    const auto last = registry.create(countedClass());
    const uint32_t index = removed->index();
    const auto old = registry.freeze();
    const ShaderObject* const before = (*old)[index].get();
    removed.reset();
    for (int i = 0; i < 1000; ++i) {
        const auto passing = registry.create(countedClass());
        ASSERT_EQ(passing->index(), index);
        ASSERT_NE((*registry.freeze())[index].get(), before);
    }
    EXPECT_EQ((*old)[index].get(), before);
    EXPECT_EQ(registry.freeze()->size(), old->size());
    EXPECT_NE(kept->index(), index);
    EXPECT_EQ(registry.create(countedClass())->index(), index);
    EXPECT_EQ(last->index(), index + 1);
}

TEST(ShaderRegistryTest, WrongValuesAreRefusedAndChangeNothing) {
    ShaderRegistry registry;
    const auto shader = registry.create(countedClass());
    const auto table = registry.freeze();
    const auto expectRefused = [&](uint32_t parameter, std::vector<std::byte> bytes) {
        try {
            shader->set(parameter, std::move(bytes));
            ADD_FAILURE() << "taken: " << parameter;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::InvalidOperation);
            EXPECT_NE(std::string(error.what()).find("Counted"), std::string::npos);
        }
    };
    expectRefused(0, bytesOf(1.0f));
    expectRefused(0, {});
    expectRefused(2, bytesOf(1.0f)); // per vertex
    expectRefused(3, bytesOf(1.0f)); // none such
    EXPECT_EQ(registry.freeze(), table);
}

TEST(ShaderRegistryTest, StringsLiveAsLongAsTheirObject) {
    std::shared_ptr<const ShaderTable> table;
    uint32_t index = 0;
    {
        ShaderRegistry registry;
        const auto shader = registry.create(countedClass());
        index = shader->index();
        std::string text(100, 'x');
        std::vector<std::byte> bytes(text.size());
        std::memcpy(bytes.data(), text.data(), text.size());
        shader->set(1, std::move(bytes));
        table = registry.freeze();
        shader->set(1, {}); // an empty string
        EXPECT_STREQ(blockOf(*(*registry.freeze())[index]).text, "");
    }
    EXPECT_EQ(blockOf(*(*table)[index]).text, std::string(100, 'x'));
}

TEST(ShaderRegistryTest, ShadersMayOutliveTheRegistryAndEndOnOtherThreads) {
    std::vector<std::shared_ptr<Shader>> kept;
    {
        ShaderRegistry registry;
        for (int i = 0; i < 64; ++i) kept.push_back(registry.create(countedClass()));
        std::vector<std::shared_ptr<Shader>> given(kept.begin(), kept.begin() + 32);
        kept.erase(kept.begin(), kept.begin() + 32);
        std::thread other([given = std::move(given)]() mutable { given.clear(); });
        for (int i = 0; i < 32; ++i) {
            kept[std::size_t(i)]->set(0, bytesOf(Color(float(i))));
            registry.freeze();
        }
        other.join();
        const auto table = registry.freeze();
        EXPECT_EQ(table->size(), 65u);
        EXPECT_EQ(std::count(table->begin(), table->end(), nullptr), 32);
    }
    kept.clear();
    EXPECT_EQ(living, 0);
}

struct FailsLater {
    static inline bool fails = false;
    Color color;
    FailsLater() {
        if (fails) throw std::runtime_error("no");
    }
    void registerParams(const ShaderRegistrator& r) const {
        r.registerParam<Color>("color", PER_SHADER, offsetof(FailsLater, color));
    }
    void shade(TraceContext&) const {}
};

TEST(ShaderRegistryTest, AFailingConstructorLeavesItsPlaceEmptyAndNothingElse) {
    ShaderRegistry registry;
    const auto failing = registry.create(
        std::make_shared<ShaderClass>(*shaderClass<FailsLater>("FailsLater"), nullptr));
    const auto other = registry.create(findBuiltinClass("Phong"));
    FailsLater::fails = true;
    const auto table = registry.freeze();
    EXPECT_EQ((*table)[failing->index()], nullptr);
    EXPECT_NE((*table)[other->index()], nullptr);
    FailsLater::fails = false;
    EXPECT_NE((*registry.freeze())[failing->index()], nullptr);
}

TEST(BuiltinTest, TheClassesOfThisReleaseExistWithTheirParameters) {
    const struct {
        const char* name;
        RTenum kind;
        std::vector<const char*> parameters;
    } expected[] = {
        {"FixedFunction", RT_SURFACE_SHADER, {}},
        {"ConstantShader", RT_SURFACE_SHADER, {"value"}},
        {"DiffuseShader", RT_SURFACE_SHADER, {"color"}},
        {"TexturedDiffuseShader", RT_SURFACE_SHADER, {"texture", "radiance"}},
        {"TextureShader", RT_SURFACE_SHADER, {"texture"}},
        {"MirrorShader", RT_SURFACE_SHADER, {"attenuation"}},
        {"Phong",
         RT_SURFACE_SHADER,
         {"ambient", "diffuse", "specular", "emissive", "shininess", "reflection", "transmission",
          "texture"}},
        {"MetallicRoughness",
         RT_SURFACE_SHADER,
         {"baseColor", "metallic", "roughness", "emissive", "baseColorTexture",
          "metallicRoughnessTexture", "emissiveTexture", "alphaMode", "alphaCutoff",
          "doubleSided", "unlit"}},
        {"Glass", RT_SURFACE_SHADER, {"index", "absorption", "color"}},
        {"AmbientOcclusion", RT_SURFACE_SHADER, {"color", "distance", "samples"}},
        {"PointLight", RT_LIGHT_SHADER, {"position", "radiance"}},
        {"SpotLightShader",
         RT_LIGHT_SHADER,
         {"position", "radiance", "direction", "cutoff", "exponent"}},
        {"PunctualLight",
         RT_LIGHT_SHADER,
         {"position", "radiance", "range", "direction", "cutoff", "innerCutoff"}},
        {"DirectionalLight", RT_LIGHT_SHADER, {"direction", "radiance"}},
        {"QuadLight",
         RT_LIGHT_SHADER,
         {"corner", "edge1", "edge2", "radiance", "samples", "twoSided"}},
        {"SphereLight", RT_LIGHT_SHADER, {"center", "radius", "radiance", "samples"}},
        {"ConstantEnvironment", RT_ENV_SHADER, {"radiance"}},
        {"ImageEnvironment", RT_ENV_SHADER, {"texture", "scale", "rotation"}},
        {"PinholeCameraShader",
         RT_CAMERA_SHADER,
         {"origin", "lowerLeft", "vertical", "horizontal"}},
        {"Pinhole", RT_CAMERA_SHADER, {"origin", "lowerLeft", "vertical", "horizontal"}},
        {"Orthographic", RT_CAMERA_SHADER, {"direction", "lowerLeft", "vertical", "horizontal"}},
        {"ThinLens",
         RT_CAMERA_SHADER,
         {"origin", "lowerLeft", "vertical", "horizontal", "aperture", "focusDistance"}},
        {"Panorama", RT_CAMERA_SHADER, {"origin", "rotation"}},
        {"Matrix", RT_CAMERA_SHADER, {"projection", "modelView"}},
        {"Default", RT_RENDERING_OBJECT_SHADER, {}},
        {"Antialias", RT_RENDERING_OBJECT_SHADER, {"contrast", "minSamples", "maxSamples"}},
        {"PathTracer", RT_RENDERING_OBJECT_SHADER, {"samples"}},
    };
    EXPECT_EQ(builtinClassNames().size(), std::size(expected));
    for (const auto& e : expected) {
        const ShaderClassPtr c = findBuiltinClass(e.name);
        ASSERT_NE(c, nullptr) << e.name;
        EXPECT_EQ(c->kind(), e.kind) << e.name;
        EXPECT_EQ(c->parameterCount(), e.parameters.size()) << e.name;
        for (const char* p : e.parameters) EXPECT_GE(c->findParameter(p), 0) << e.name << " " << p;
    }
    EXPECT_EQ(findBuiltinClass("Nonsense"), nullptr);
    EXPECT_EQ(findBuiltinClass(""), nullptr);
}

} // namespace
} // namespace smart
