// SPDX-License-Identifier: MIT
#include "libsmart/render/shading_services.h"

namespace smart {

template class ShadingServices<DynamicShading>;

} // namespace smart
