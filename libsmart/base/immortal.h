// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <new>

namespace smart {

/// A static object that outlives every destructor and exit handler of the process: it is made but
/// never ended. What it holds by then is up to its users.
template <class T>
class Immortal {
public:
    Immortal() { new (storage_) T; }
    Immortal(const Immortal&) = delete;
    Immortal& operator=(const Immortal&) = delete;

    T& get() noexcept { return *std::launder(reinterpret_cast<T*>(storage_)); }

private:
    alignas(T) std::byte storage_[sizeof(T)];
};

} // namespace smart
