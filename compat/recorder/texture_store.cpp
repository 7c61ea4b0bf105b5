// SPDX-License-Identifier: MIT
#include "compat/recorder/texture_store.h"

#include "libsmart/base/error.h"

namespace smart::compat {

uint32_t TextureStore::generate() {
    if (objects_.size() > kMaxId) throw Error(ErrorCode::OutOfMemory, "all texture ids are in use");
    uint32_t id = lastGenerated_;
    do id = id == kMaxId ? 1 : id + 1;
    while (objects_.contains(id));
    objects_.try_emplace(id);
    return lastGenerated_ = id;
}

void TextureStore::remove(uint32_t id) {
    if (id == 0 || objects_.erase(id) == 0) return;
    if (bound_ == id) bound_ = 0;
    table_.reset();
}

void TextureStore::bind(uint32_t id) {
    if (id > kMaxId) throw Error(ErrorCode::InvalidValue, "texture ids end at 1048575");
    objects_[id].everBound = true;
    bound_ = id;
}

bool TextureStore::exists(uint32_t id) const {
    const auto found = objects_.find(id);
    return id != 0 && found != objects_.end() && found->second.everBound;
}

void TextureStore::setImage(std::shared_ptr<const Texture> image) {
    Object& object = objects_.at(bound_);
    if (image) object.options = image->options();
    object.image = std::move(image);
    object.stale = false;
    table_.reset();
}

const TextureOptions& TextureStore::options() const {
    return objects_.at(bound_).options;
}

void TextureStore::setOptions(const TextureOptions& options) {
    Object& object = objects_.at(bound_);
    object.options = options;
    object.stale = object.image != nullptr;
    table_.reset();
}

std::shared_ptr<const TextureTable> TextureStore::freeze() {
    if (table_) return table_;
    auto table = std::make_shared<TextureTable>(objects_.rbegin()->first + 1);
    for (auto& [id, object] : objects_) {
        if (object.stale)
            object.image = std::make_shared<const Texture>(object.image->withOptions(object.options));
        object.stale = false;
        if (id != 0) (*table)[id] = object.image;
    }
    return table_ = std::move(table);
}

} // namespace smart::compat
