// SPDX-License-Identifier: MIT
#include "compat/recorder/texture_store.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "libsmart/base/error.h"

namespace smart::compat {

TextureStore::TextureStore() {
    objects_[0].target = TextureTarget::TwoDimensional;
    objects_[kDefault1D].target = TextureTarget::OneDimensional;
}

uint32_t TextureStore::generate() {
    if (objects_.size() > kMaxId + 1) throw Error(ErrorCode::OutOfMemory, "all texture ids are in use");
    uint32_t id = lastGenerated_;
    do id = id == kMaxId ? 1 : id + 1;
    while (objects_.contains(id));
    objects_.try_emplace(id);
    return lastGenerated_ = id;
}

void TextureStore::remove(uint32_t id) {
    if (id == 0 || id > kMaxId || objects_.erase(id) == 0) return;
    for (Bindings& unit : bound_) {
        if (unit.keys[0] == id) unit.keys[0] = kDefault1D;
        if (unit.keys[1] == id) unit.keys[1] = 0;
    }
    table_.reset();
}

void TextureStore::bind(uint32_t id, TextureTarget target) {
    if (id > kMaxId) throw Error(ErrorCode::InvalidValue, "texture ids end at 1048575");
    const bool isLine = target == TextureTarget::OneDimensional;
    const uint32_t key = id == 0 && isLine ? kDefault1D : id;
    Object& object = objects_[key];
    if (object.target.value_or(target) != target)
        throw Error(ErrorCode::InvalidOperation,
                    "the texture has another number of dimensions");
    object.target = target;
    bound_[unit_].keys[std::size_t(target)] = key;
}

bool TextureStore::exists(uint32_t id) const {
    const auto found = objects_.find(id);
    return id != 0 && id <= kMaxId && found != objects_.end() && found->second.target;
}

void TextureStore::setImage(uint32_t level, TextureImagePtr image, int32_t internalFormat,
                            TexelFormat format, TextureTarget target) {
    Object& object = objects_.at(keyOfBound(target));
    const bool given = image != nullptr;
    if (given)
        object.levels[level] = {std::move(image), internalFormat, format};
    else
        object.levels.erase(level);
    if (level == object.madeFrom) object.madeFrom.reset();
    const TextureParameters& p = object.parameters;
    if (given && p.generateMipmap && level == p.options.firstLevel) {
        object.madeFrom = level;
        object.levels.erase(object.levels.upper_bound(level), object.levels.end());
    }
    object.images.reset();
    object.stale = true;
    table_.reset();
}

void TextureStore::setPart(uint32_t level, uint32_t x, uint32_t y, const TextureImage& part,
                           TextureTarget target) {
    Object& object = objects_.at(keyOfBound(target));
    const TextureLevelInfo old = info(level, target);
    // Where only these hold the image still, no frame does.
    object.images.reset();
    object.texture.reset();
    object.stale = true;
    table_.reset();
    const Level* const given = object.find(level);
    std::shared_ptr<TextureImage> image;
    if (given && given->image.use_count() == 1) {
        TextureImagePtr(given->image).reset(); // after whatever the last frame that had it did
        image = std::const_pointer_cast<TextureImage>(given->image);
    } else {
        image = std::make_shared<TextureImage>(*this->image(level, target));
    }
    image->setPart(x, y, part);
    setImage(level, std::move(image), old.internalFormat, old.format, target);
}

TextureImagePtr TextureStore::image(uint32_t level, TextureTarget target) const {
    const Object& object = objects_.at(keyOfBound(target));
    if (const Level* given = object.find(level)) return given->image;
    if (!object.madeFrom || level < *object.madeFrom || level > object.lastMade()) return nullptr;
    TextureImagePtr made = object.find(*object.madeFrom)->image;
    for (uint32_t i = *object.madeFrom; i < level; ++i)
        made = std::make_shared<const TextureImage>(reducedImage(*made));
    return made;
}

TextureLevelInfo TextureStore::info(uint32_t level, TextureTarget target) const {
    const Object& object = objects_.at(keyOfBound(target));
    uint32_t from = level;
    if (!object.find(level)) {
        if (!object.madeFrom || level < *object.madeFrom || level > object.lastMade()) return {};
        from = *object.madeFrom;
    }
    const Level& source = *object.find(from);
    TextureLevelInfo info{source.image->width(), source.image->height(), source.image->channels(),
                          source.image->type(), source.internalFormat, source.format};
    for (; from < level; ++from) {
        info.width = nextLevelSide(info.width);
        info.height = nextLevelSide(info.height);
    }
    return info;
}

void TextureStore::setParameters(const TextureParameters& parameters, TextureTarget target) {
    Object& object = objects_.at(keyOfBound(target));
    object.parameters = parameters;
    object.stale = true;
    table_.reset();
}

const TextureStore::Level* TextureStore::Object::find(uint32_t level) const {
    const auto found = levels.find(level);
    return found == levels.end() ? nullptr : &found->second;
}

uint32_t TextureStore::Object::lastMade() const {
    const TextureImage& image = *find(*madeFrom)->image;
    return *madeFrom + levelCount(image.width(), image.height()) - 1;
}

/// Whether the levels have the sizes and formats that mipmaps of the first one have.
bool TextureStore::Object::complete(uint32_t start, uint32_t count) const {
    const Level& first = *find(start);
    uint32_t width = first.image->width(), height = first.image->height();
    for (uint32_t number = start; number < start + count; ++number) {
        const Level* level = find(number);
        const bool made = !level && madeFrom && start >= *madeFrom && number <= lastMade();
        const bool fits = level && level->image->width() == width &&
                          level->image->height() == height &&
                          level->internalFormat == first.internalFormat;
        if (!made && !fits) return false;
        width = nextLevelSide(width);
        height = nextLevelSide(height);
    }
    return true;
}

/// Sets `images` to levels start, start + 1, ...; `all`: with those that were given.
void TextureStore::Object::gather(uint32_t start, uint32_t count, bool all) {
    if (images && imagesStart == start && images->count() == count) return;
    std::vector<TextureImagePtr> given{find(start)->image};
    for (uint32_t number = start + 1; all && number < start + count; ++number) {
        const Level* level = find(number);
        given.push_back(level ? level->image : nullptr);
    }
    images = std::make_shared<const TextureLevels>(std::move(given), count);
    imagesStart = start;
}

// OpenGL 1.5, section 3.8.10, on completeness; see freeze() in the header for what comes of its
// lack.
void TextureStore::Object::freeze() {
    const uint32_t base = parameters.options.firstLevel;
    uint32_t start = base;
    if (!find(base)) { // it may be one of those that are made
        if (!madeFrom || base < *madeFrom || base > lastMade()) {
            texture.reset();
            whole = stale = false;
            return;
        }
        start = *madeFrom;
    }
    const TextureImage& first = *find(start)->image;
    const uint32_t end = start + levelCount(first.width(), first.height());
    const uint32_t wanted = parameters.options.lastLevel < end - 1
                                ? std::max(parameters.options.lastLevel, base) + 1
                                : end;
    TextureOptions options = parameters.options;
    options.firstLevel = base - start;
    options.lastLevel = end;
    whole = parameters.options.lastLevel >= base && complete(start, wanted - start);
    gather(start, whole ? wanted - start : base - start + 1, whole);
    options.format = find(start)->format;
    // The second coordinate is not looked at: beyond the edge is the only row.
    if (target == TextureTarget::OneDimensional) options.wrapT = TextureWrap::ClampToEdge;
    if (options.minification.levels == LevelChoice::First)
        whole = true; // the others are not asked for
    else if (!whole)
        options.minification = {options.magnification, LevelChoice::First};
    texture = std::make_shared<const Texture>(images, options);
    stale = false;
}

std::shared_ptr<const Texture> TextureStore::completeBound(TextureTarget target,
                                                           std::size_t unit) {
    Object& object = objects_.at(bound_[unit].keys[std::size_t(target)]);
    if (object.stale) object.freeze();
    return object.whole ? object.texture : nullptr;
}

std::shared_ptr<const TextureTable> TextureStore::freeze() {
    if (table_) return table_;
    const uint32_t largest = std::prev(objects_.find(kDefault1D))->first;
    auto table = std::make_shared<TextureTable>(largest + 1);
    for (auto& [id, object] : objects_) {
        if (object.stale) object.freeze();
        if (id != 0 && id != kDefault1D) (*table)[id] = object.texture;
    }
    return table_ = std::move(table);
}

} // namespace smart::compat
