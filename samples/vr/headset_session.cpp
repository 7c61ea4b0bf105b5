// SPDX-License-Identifier: MIT
#include "samples/vr/headset_session.h"

#include <GL/gl.h>
#include <GL/glx.h>
#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace samples {

namespace {

constexpr int64_t kSrgb = 0x8C43; // GL_SRGB8_ALPHA8

void check(XrResult result, const char* what) {
    if (XR_SUCCEEDED(result)) return;
    const char* reason = result == XR_ERROR_RUNTIME_UNAVAILABLE ? "no OpenXR runtime is installed"
                         : result == XR_ERROR_FORM_FACTOR_UNAVAILABLE ? "no display is connected"
                                                                      : nullptr;
    throw std::runtime_error(std::string(what) + " failed: " +
                             (reason ? reason : "OpenXR error " + std::to_string(result)));
}

template <class Structure>
Structure make(XrStructureType type) {
    Structure structure{};
    structure.type = type;
    return structure;
}

} // namespace

struct HeadsetSession::State {
    struct Swapchain {
        XrSwapchain handle = XR_NULL_HANDLE;
        std::vector<XrSwapchainImageOpenGLKHR> images;
    };

    ~State() {
        for (const Swapchain& swapchain : swapchains) xrDestroySwapchain(swapchain.handle);
        if (space) xrDestroySpace(space);
        if (session) xrDestroySession(session);
        if (instance) xrDestroyInstance(instance);
    }

    void makeInstance(const std::string& application) {
        uint32_t count = 0;
        check(xrEnumerateInstanceExtensionProperties(nullptr, 0, &count, nullptr),
              "asking for OpenXR's extensions");
        std::vector<XrExtensionProperties> known(
            count, make<XrExtensionProperties>(XR_TYPE_EXTENSION_PROPERTIES));
        check(xrEnumerateInstanceExtensionProperties(nullptr, count, &count, known.data()),
              "asking for OpenXR's extensions");
        const char* const wanted = XR_KHR_OPENGL_ENABLE_EXTENSION_NAME;
        if (std::none_of(known.begin(), known.end(), [&](const XrExtensionProperties& extension) {
                return std::strcmp(extension.extensionName, wanted) == 0;
            }))
            throw std::runtime_error("the OpenXR runtime takes no pictures of OpenGL");
        auto info = make<XrInstanceCreateInfo>(XR_TYPE_INSTANCE_CREATE_INFO);
        application.copy(info.applicationInfo.applicationName, XR_MAX_APPLICATION_NAME_SIZE - 1);
        std::strcpy(info.applicationInfo.engineName, "OpenRT");
        info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
        info.enabledExtensionCount = 1;
        info.enabledExtensionNames = &wanted;
        check(xrCreateInstance(&info, &instance), "starting OpenXR");
    }

    void makeSession() {
        auto wanted = make<XrSystemGetInfo>(XR_TYPE_SYSTEM_GET_INFO);
        wanted.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
        XrSystemId system = XR_NULL_SYSTEM_ID;
        check(xrGetSystem(instance, &wanted, &system), "looking for a head-mounted display");
        // The runtime insists on being asked before a session is made.
        PFN_xrGetOpenGLGraphicsRequirementsKHR requirementsOf = nullptr;
        check(xrGetInstanceProcAddr(instance, "xrGetOpenGLGraphicsRequirementsKHR",
                                    reinterpret_cast<PFN_xrVoidFunction*>(&requirementsOf)),
              "asking for OpenXR's OpenGL");
        auto requirements =
            make<XrGraphicsRequirementsOpenGLKHR>(XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR);
        check(requirementsOf(instance, system, &requirements), "asking for OpenXR's OpenGL");

        auto graphics =
            make<XrGraphicsBindingOpenGLXlibKHR>(XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR);
        graphics.xDisplay = glXGetCurrentDisplay();
        graphics.glxContext = glXGetCurrentContext();
        graphics.glxDrawable = glXGetCurrentDrawable();
        if (!graphics.xDisplay || !graphics.glxContext)
            throw std::runtime_error("OpenXR needs a window of X11");
        auto info = make<XrSessionCreateInfo>(XR_TYPE_SESSION_CREATE_INFO);
        info.next = &graphics;
        info.systemId = system;
        check(xrCreateSession(instance, &info, &session), "making an OpenXR session");

        auto place = make<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
        place.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_STAGE;
        place.poseInReferenceSpace.orientation.w = 1;
        if (XR_FAILED(xrCreateReferenceSpace(session, &place, &space))) {
            // Seated: the head starts where a visitor of average height stands in a room.
            place.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_LOCAL;
            place.poseInReferenceSpace.position.y = -1.7f;
            check(xrCreateReferenceSpace(session, &place, &space), "placing the OpenXR session");
        }

        uint32_t count = 0;
        check(xrEnumerateViewConfigurationViews(instance, system, kStereo, 0, &count, nullptr),
              "asking for the display's eyes");
        std::vector<XrViewConfigurationView> recommended(
            count, make<XrViewConfigurationView>(XR_TYPE_VIEW_CONFIGURATION_VIEW));
        check(xrEnumerateViewConfigurationViews(instance, system, kStereo, count, &count,
                                                recommended.data()),
              "asking for the display's eyes");
        size = {recommended.at(0).recommendedImageRectWidth,
                recommended.at(0).recommendedImageRectHeight};
        for (uint32_t i = 0; i < count; ++i) makeSwapchain();
    }

    void makeSwapchain() {
        auto info = make<XrSwapchainCreateInfo>(XR_TYPE_SWAPCHAIN_CREATE_INFO);
        info.usageFlags =
            XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_TRANSFER_DST_BIT;
        info.format = kSrgb;
        info.sampleCount = info.faceCount = info.arraySize = info.mipCount = 1;
        info.width = size.width;
        info.height = size.height;
        Swapchain& made = swapchains.emplace_back();
        check(xrCreateSwapchain(session, &info, &made.handle), "making an OpenXR swapchain");
        uint32_t count = 0;
        check(xrEnumerateSwapchainImages(made.handle, 0, &count, nullptr), "asking for images");
        made.images.resize(count,
                           make<XrSwapchainImageOpenGLKHR>(XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR));
        check(xrEnumerateSwapchainImages(
                  made.handle, count, &count,
                  reinterpret_cast<XrSwapchainImageBaseHeader*>(made.images.data())),
              "asking for images");
    }

    void show(const Swapchain& swapchain, const std::vector<uint8_t>& picture) const {
        const auto acquire =
            make<XrSwapchainImageAcquireInfo>(XR_TYPE_SWAPCHAIN_IMAGE_ACQUIRE_INFO);
        uint32_t index = 0;
        check(xrAcquireSwapchainImage(swapchain.handle, &acquire, &index), "taking an image");
        auto wait = make<XrSwapchainImageWaitInfo>(XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO);
        wait.timeout = XR_INFINITE_DURATION;
        check(xrWaitSwapchainImage(swapchain.handle, &wait), "waiting for an image");
        glBindTexture(GL_TEXTURE_2D, swapchain.images.at(index).image);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, GLsizei(size.width), GLsizei(size.height), GL_RGBA,
                        GL_UNSIGNED_BYTE, picture.data());
        glBindTexture(GL_TEXTURE_2D, 0);
        const auto release =
            make<XrSwapchainImageReleaseInfo>(XR_TYPE_SWAPCHAIN_IMAGE_RELEASE_INFO);
        check(xrReleaseSwapchainImage(swapchain.handle, &release), "giving an image back");
    }

    void changeTo(XrSessionState next) {
        if (next == XR_SESSION_STATE_READY) {
            auto begin = make<XrSessionBeginInfo>(XR_TYPE_SESSION_BEGIN_INFO);
            begin.primaryViewConfigurationType = kStereo;
            check(xrBeginSession(session, &begin), "beginning the OpenXR session");
            running = true;
        } else if (next == XR_SESSION_STATE_STOPPING) {
            running = false;
            check(xrEndSession(session), "ending the OpenXR session");
        } else if (next == XR_SESSION_STATE_EXITING || next == XR_SESSION_STATE_LOSS_PENDING) {
            running = false;
            over = true;
        }
    }

    static constexpr XrViewConfigurationType kStereo = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;

    XrInstance instance = XR_NULL_HANDLE;
    XrSession session = XR_NULL_HANDLE;
    XrSpace space = XR_NULL_HANDLE;
    std::vector<Swapchain> swapchains;
    PictureSize size{};
    bool running = false, over = false;
    XrTime moment = 0;
    std::vector<XrView> views; ///< of this moment
};

HeadsetSession::HeadsetSession(const std::string& application) : state_(std::make_unique<State>()) {
    state_->makeInstance(application);
    state_->makeSession();
}

HeadsetSession::~HeadsetSession() = default;

std::size_t HeadsetSession::eyes() const {
    return state_->swapchains.size();
}
PictureSize HeadsetSession::pictureSize() const {
    return state_->size;
}
bool HeadsetSession::running() const {
    return state_->running;
}

bool HeadsetSession::poll() {
    auto event = make<XrEventDataBuffer>(XR_TYPE_EVENT_DATA_BUFFER);
    while (xrPollEvent(state_->instance, &event) == XR_SUCCESS) {
        if (event.type == XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING) state_->over = true;
        if (event.type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) {
            XrEventDataSessionStateChanged change;
            std::memcpy(&change, &event, sizeof change);
            state_->changeTo(change.state);
        }
        event = make<XrEventDataBuffer>(XR_TYPE_EVENT_DATA_BUFFER);
    }
    return !state_->over;
}

std::vector<HeadsetEye> HeadsetSession::beginFrame() {
    const auto wait = make<XrFrameWaitInfo>(XR_TYPE_FRAME_WAIT_INFO);
    auto frame = make<XrFrameState>(XR_TYPE_FRAME_STATE);
    check(xrWaitFrame(state_->session, &wait, &frame), "waiting for the next moment");
    const auto begin = make<XrFrameBeginInfo>(XR_TYPE_FRAME_BEGIN_INFO);
    check(xrBeginFrame(state_->session, &begin), "beginning a moment");
    state_->moment = frame.predictedDisplayTime;
    if (!frame.shouldRender) return {};

    auto locate = make<XrViewLocateInfo>(XR_TYPE_VIEW_LOCATE_INFO);
    locate.viewConfigurationType = State::kStereo;
    locate.displayTime = state_->moment;
    locate.space = state_->space;
    auto located = make<XrViewState>(XR_TYPE_VIEW_STATE);
    uint32_t count = uint32_t(eyes());
    state_->views.assign(count, make<XrView>(XR_TYPE_VIEW));
    check(xrLocateViews(state_->session, &locate, &located, count, &count, state_->views.data()),
          "locating the eyes");
    constexpr XrViewStateFlags kKnown =
        XR_VIEW_STATE_POSITION_VALID_BIT | XR_VIEW_STATE_ORIENTATION_VALID_BIT;
    if ((located.viewStateFlags & kKnown) != kKnown) return {};
    std::vector<HeadsetEye> seen;
    for (const XrView& view : state_->views) {
        const XrPosef& pose = view.pose;
        HeadsetEye& eye = seen.emplace_back();
        eye.position = {pose.position.x, pose.position.y, pose.position.z};
        eye.orientation = glm::dquat(pose.orientation.w, pose.orientation.x, pose.orientation.y,
                                     pose.orientation.z);
        eye.left = view.fov.angleLeft;
        eye.right = view.fov.angleRight;
        eye.up = view.fov.angleUp;
        eye.down = view.fov.angleDown;
    }
    return seen;
}

void HeadsetSession::endFrame(const std::vector<HeadsetEye>& eyes,
                              const std::vector<std::vector<uint8_t>>& pictures) {
    std::vector<XrCompositionLayerProjectionView> shown;
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        state_->show(state_->swapchains[i], pictures[i]);
        auto& view = shown.emplace_back(
            make<XrCompositionLayerProjectionView>(XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW));
        view.pose = state_->views[i].pose;
        view.fov = state_->views[i].fov;
        view.subImage.swapchain = state_->swapchains[i].handle;
        view.subImage.imageRect.extent = {int32_t(state_->size.width),
                                          int32_t(state_->size.height)};
    }
    auto layer = make<XrCompositionLayerProjection>(XR_TYPE_COMPOSITION_LAYER_PROJECTION);
    layer.space = state_->space;
    layer.viewCount = uint32_t(shown.size());
    layer.views = shown.data();
    const auto* const base = reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer);
    auto end = make<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
    end.displayTime = state_->moment;
    end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
    end.layerCount = shown.empty() ? 0 : 1;
    end.layers = &base;
    check(xrEndFrame(state_->session, &end), "ending a moment");
}

} // namespace samples
