// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "compat/recorder/attributes.h"
#include "compat/recorder/compiled_run.h"
#include "compat/recorder/fixed_state_recorder.h"
#include "compat/recorder/frame_settings.h"
#include "compat/recorder/geometry_recording.h"
#include "compat/recorder/idle_state.h"
#include "compat/recorder/matrix_stack.h"
#include "compat/recorder/model_compiler.h"
#include "compat/recorder/pixel_drawing.h"
#include "compat/recorder/pixel_unpack.h"
#include "compat/recorder/scene_store.h"
#include "compat/recorder/shader_catalog.h"
#include "compat/recorder/texture_store.h"
#include "libsmart/render/window_image.h"

namespace smart::compat {

enum class ObjectMode : uint8_t { Define, DefineAndInstantiate };
enum class UniqueShader : uint8_t { Camera, Environment, RenderingObject };

/// The state machine behind the immediate calls: attributes, matrices, objects, and the scenes of
/// the frames under way. Everything it hands on is immutable. Belongs to one context's thread.
///
/// Every function checks first and throws Error before it changes anything; when memory runs out
/// nothing has changed either.
class Recorder {
public:
    // Where the calls stand. Each throws Error (InvalidOperation) if it does not hold.
    bool insidePrimitive() const { return insidePrimitive_; }
    bool insideObject() const { return open_ != nullptr; }
    /// Id of the object that is being defined; 0: none.
    uint32_t openObject() const { return open_ ? open_->id : 0; }
    void requireOutsidePrimitive() const;
    /// Between neither begin and end nor newObject and endObject.
    void requireOutsideObject() const;

    // Primitives and attributes.
    void begin(Primitive primitive);
    void end();
    void vertex(const glm::dvec4& position);
    void color(const glm::vec4& color);
    void normal(const glm::vec3& normal);
    void texCoord(const glm::vec4& texCoord, std::size_t unit = 0);
    /// The materials of both sides; legal everywhere.
    void setMaterials(FixedMaterials materials);
    /// As they are now: what follows the current colour is brought up to date.
    FixedMaterials materials() const;
    void setEdgeFlag(bool flag) { attributes_.edgeFlag = flag; }
    void secondaryColor(const glm::vec4& color);
    void fogCoordinate(float coordinate);
    const Attributes& attributes() const { return attributes_; }

    // The raster position, and what is drawn there; not in objects. Images of no size are none.
    void setRasterPosition(const glm::dvec4& position);
    /// In the window; z from 0, the near plane, to 1.
    void setWindowPosition(const glm::dvec3& position);
    /// `bitmap` nullptr: moves the raster position only.
    void drawBitmap(std::shared_ptr<const ImagePixels> bitmap, const glm::dvec2& origin,
                    const glm::dvec2& move);
    void drawPixels(std::shared_ptr<const ImagePixels> pixels);
    PixelDrawing& pixelDrawing() { return requireOutsideObject(), pixelDrawing_; }
    const PixelDrawing& pixelDrawingNow() const { return pixelDrawing_; }

    // State; outside primitives.
    Matrices& matrices() { return requireOutsidePrimitive(), matrices_; }
    ShaderCatalog& shaders() { return requireOutsidePrimitive(), shaders_; }
    TextureStore& textures() { return requireOutsidePrimitive(), textures_; }
    /// The texture unit that calls about textures, their environment and matrices mean.
    std::size_t textureUnit() const { return textureUnit_; }
    void selectTextureUnit(std::size_t unit);
    PixelStore& pixelStore() { return requireOutsidePrimitive(), pixelStore_; }
    /// Of pixels that are read back.
    PixelStore& packStore() { return requireOutsidePrimitive(), packStore_; }
    BuildHints& buildHints() { return requireOutsidePrimitive(), buildHints_; }
    FrameSettings& frameSettings() { return requireOutsidePrimitive(), frameSettings_; }
    /// To be changed.
    FixedStateRecorder& fixedState() { return requireOutsideObject(), fixedState_; }
    const FixedState& fixedStateNow() const { return fixedState_.state(); }
    const FixedTexture& fixedTextureNow() const { return fixedState_.texture(); }
    IdleState& idleState() { return requireOutsideObject(), idleState_; }
    const IdleState& idleStateNow() const { return idleState_; }
    /// As before a push of attributes.
    void restoreAttributes(const Attributes& attributes);
    /// The same of materials, whatever follows the colour; outside of objects.
    void restoreMaterials(std::shared_ptr<const FixedMaterials> materials) noexcept;
    const ModelCompiler& compiler() const { return compiler_; }
    void setBuildThreads(unsigned threads) { compiler_.setThreads(threads); }
    // Rays, by which the library chooses among builders.
    /// So many were asked for outside of frames.
    void countQueryRays(uint64_t rays) noexcept { queryRays_ += rays; }
    /// All but camera rays of the frames that have ended.
    void setFrameRays(uint64_t rays) noexcept { frameRays_ = rays; }
    /// All so far.
    uint64_t rays() const noexcept { return cameraRays_ + queryRays_ + frameRays_; }

    /// Legal everywhere.
    void setParameter(uint32_t handle, const ParameterValue& value) {
        shaders_.setParameter(handle, value);
    }

    // Objects.
    uint32_t newObject(ObjectMode mode);
    void replaceObject(uint32_t id);
    void endObject();
    /// New positions, x, y, z each, of the vertices first.. of an object in the order given.
    void updateObject(uint32_t id, uint32_t first, uint32_t count, const float* positions);
    /// Throws unless the object has these vertices.
    void requireVertices(uint32_t id, uint32_t first, uint32_t count) const;
    void removeObject(uint32_t id);
    /// Places an object in the scene, or in the object under definition.
    void instantiate(uint32_t id);
    void instantiateWithShader(uint32_t id, uint32_t shader);
    void instantiateWithShaders(uint32_t id, std::span<const uint32_t> shaders);
    /// Ids of the shaders of an object in order of first use.
    const std::vector<UsedShader>& objectShaders(uint32_t id) const;
    bool hasObject(uint32_t id) const { return objects_.contains(id); }

    // Runs of primitives of display lists, each an object without an id.
    /// Whether runs can be placed here and now; else their calls are to be made one by one.
    bool canPlaceRuns() const;
    /// Makes the calls as in an object, of which only the model is left. What a call throws comes
    /// through.
    CompiledRun compileRun(const std::function<void()>& calls);
    /// One that fits the bound shader, where runs can be placed.
    void placeRun(const CompiledRun& run);

    // Scenes. What follows acts on the bound one, as everything that adds to a frame does.
    uint32_t newScene();
    void bindScene(uint32_t id);
    void removeScene(uint32_t id);
    uint32_t boundScene() const { return scenes_.boundId(); }

    // The frame under way.
    void useLight(uint32_t shader, bool checkTwice);
    void useUnique(UniqueShader what, uint32_t shader);
    /// Clears what the masks of colour and depth, and the scissor, leave to be cleared.
    void clear(bool color, bool depth);
    /// The scene so far, which stays open.
    ScenePtr compileScene();
    /// Everything described so far as a frame; the scene stays open.
    std::shared_ptr<Frame> makeFrame() { return makeFrame(frameSettings_.target); }
    /// The same into other memory.
    std::shared_ptr<Frame> makeFrame(const PixelTarget& target);
    /// What `frame` shows, seen by the camera that the bound scene uses now.
    std::shared_ptr<Frame> makeView(const Frame& frame, const PixelTarget& target);
    void dropCamera() noexcept { scene().camera.reset(); }
    /// Starts a new, empty scene.
    void clearScene() noexcept;
    /// Whether nothing was added to it.
    bool sceneIsEmpty() const { return scenes_.bound().additions == 0; }
    /// Whether something was added since sceneIsFinished().
    bool sceneHasNews() const {
        return scenes_.bound().additions != scenes_.bound().finishedAdditions;
    }
    void sceneIsFinished() noexcept { scene().finishedAdditions = scene().additions; }

private:
    struct Object {
        ModelPtr model;
        std::vector<UsedShader> shaders;
        BuildHints hints;          ///< when it was defined
        uint64_t raysThen = 0;     ///< rays() when it was built last
    };
    struct OpenObject {
        uint32_t id;
        ObjectMode mode;
        GeometryRecording recording;
        Matrices savedMatrices;
        Attributes savedAttributes;
    };
    SceneRecording& scene() { return scenes_.bound(); }
    const Object& object(uint32_t id) const;
    /// For an object of so many triangles, built before if `old` is.
    BuildQuality qualityFor(const BuildHints& hints, const Object* old,
                            std::size_t triangles) const;
    void openObject(uint32_t id, ObjectMode mode);
    /// Back to what the object under definition found.
    void closeObject() noexcept;
    /// `shaders`: those that the instance uses in the end.
    void place(uint32_t id, std::shared_ptr<const ShaderReplacement> replacement,
               const std::vector<UsedShader>& shaders);
    /// Appends to the scene, after the loose run under way; `complete` may still fill in the
    /// instance and is the last step that may fail.
    template <class Complete>
    void placeInScene(Instance instance, Complete&& complete);
    const BoundShaderPtr& surface(uint32_t id) const;
    std::shared_ptr<Shader> shaderOfKind(uint32_t id, RTenum kind, const char* kindName) const;
    /// The loose run under way as an instance; the run stays open. Nothing without triangles.
    std::optional<Instance> looseInstance();
    /// The model of a run as long as the run before it in this place was the same; the tree gets
    /// better where that pays. Else compiles it. `spare`: is emptied then, and may be a copy.
    ModelPtr sameLooseRun() const;
    ModelPtr compileLooseRun(GeometryRecording& spare);
    /// Makes the loose run, if there is one, an instance.
    void endLooseRun();
    InstanceList allInstances();
    void resumeLooseRun() noexcept;

    /// The state that instances placed now have, or loose geometry begun now.
    FixedStatePtr instanceState(const Matrices& matrices);
    FixedStatePtr looseState();
    FixedStateSources stateSources(const Matrices& matrices, const glm::dmat4& objectToEye);
    TextureSource textureSource(const FixedTexture& texture, std::size_t unit,
                                const Matrices& matrices);
    InheritedAttributes inheritedFrom(const Attributes& attributes);
    /// As instances share them; nullptr: OpenGL's initial ones.
    std::shared_ptr<const MoreTexCoords> sharedTexCoords(const Attributes& attributes);
    void beginLoose(Primitive primitive);
    /// Ends the loose run if it has another state than what comes now.
    void openLooseRun();
    LayerView currentView() const;
    Viewport scissorNow() const;
    /// What is added next belongs to the layer that is seen as the state says now.
    void enterLayer();
    void endLayer();
    /// Whether the layer under way has primitives.
    bool hasContent() const;
    void freezeShaders(Frame& frame);
    /// A layer without scene, with the shaders of `common`.
    std::shared_ptr<Frame> makeLayer(const Frame& common, const PixelTarget& target,
                                     const LayerView& view) const;
    /// For normals of loose geometry, which is kept in eye space.
    glm::dmat3 looseNormalMatrix() const;
    Viewport viewportNow() const;
    /// At the raster position, which is valid.
    void addImage(WindowImage image);

    bool insidePrimitive_ = false;
    Attributes attributes_;
    bool normalEverGiven_ = false; ///< outside objects
    Matrices matrices_;
    ShaderCatalog shaders_;
    TextureStore textures_;
    std::size_t textureUnit_ = 0;
    std::shared_ptr<const MoreTexCoords> sharedTexCoords_; ///< the last ones that were
    PixelStore pixelStore_, packStore_;
    BuildHints buildHints_;
    FrameSettings frameSettings_;
    FixedStateRecorder fixedState_;
    IdleState idleState_;
    PixelDrawing pixelDrawing_;
    ModelCompiler compiler_;

    std::map<uint32_t, Object> objects_;
    uint64_t cameraRays_ = 0; ///< of all frames started so far
    uint64_t queryRays_ = 0, frameRays_ = 0;
    uint32_t lastObject_ = 0;
    std::unique_ptr<OpenObject> open_;
    SceneStore scenes_;

    // Of the model-view matrix that the current primitive began with.
    glm::dmat3 normalMatrix_{1.0};
};

} // namespace smart::compat
