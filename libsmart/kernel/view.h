// SPDX-License-Identifier: MIT
// The scene as kernels see it: raw pointers to memory that Model and Scene own.
#pragma once

#include <cstdint>

#include "libsmart/accel/kd_node.h"
#include "libsmart/accel/wide_node.h"

namespace smart {

/// Neighbours hold their shared vertices bit for bit.
struct Triangle {
    float v0[3], v1[3], v2[3];
};

/// Record of the fast mode, after Wald's thesis (2004), chapter 7: the plane projected along
/// its dominant axis k, and the two edge equations there. A degenerate triangle has axis 3.
struct TriangleRecord {
    float nu, nv, nd; ///< plane: dir[k] = 1, nu = n[ku]/n[k], nv = n[kv]/n[k], nd = v0.n/n[k]
    uint32_t axis;
    float bu, bv, bd; ///< u = bu * h[ku] + bv * h[kv] + bd: weight of the second vertex
    float cu, cv, cd; ///< v likewise: weight of the third
};

/// What a tree spans.
struct BoxView {
    float lo[3], hi[3];
    float maxAbs; ///< largest absolute coordinate of the box; scale of the padding
};

struct KdView : BoxView {
    const KdNode* nodes; ///< nullptr: nothing in it, or not built
    const uint32_t* prims;
};

/// A tree of wide nodes.
struct WideView : BoxView {
    const WideNode* nodes; ///< nullptr: nothing in it, or not built
    const uint32_t* prims; ///< numbers of the primitives, leaf by leaf
    /// Of a tree over triangles, instead of prims: a leaf of n triangles from entry f on owns the
    /// words from 10 f on. These are n times the x of v0, n times its y and so on to the z of v2,
    /// and n numbers of triangles. A whole packet of words may be read behind the last.
    const float* blocks;
};

struct ModelView;

/// Of a model whose tree is built when the first ray comes.
struct DeferredView {
    /// What rays walk in the model; lasts as long as building does. Called by any thread.
    const ModelView* (*reach)(const DeferredView&);
};

struct InstanceTraits;

/// A child in its parent's space. Rays enter it in double, by the inverse of its matrix, so that
/// the ray in object space carries one rounding only; see affine_inverse.h.
struct InstanceView {
    double toParent[4][3];  ///< the matrix as given: four columns of three
    const ModelView* model; ///< nullptr: no ray can hit it
    uint16_t identity;      ///< not 0: the matrix is the identity and needs no arithmetic
    uint16_t usual;         ///< not 0: invertUsual() will do
    // Not for kernels:
    uint32_t objectId;
    const InstanceTraits* traits;
};

/// A model: its own triangles, and child instances with a tree over them. The scene itself is a
/// ModelView without triangles.
struct ModelView {
    const Triangle* triangles;
    const TriangleRecord* records; ///< nullptr unless a frame in fast mode asked for them
    KdView tree;
    WideView wide; ///< over the triangles too: a model has the one or the other
    const InstanceView* children;
    WideView childTree;
    /// 0 where no child can be hit. One child needs no tree: childTree.nodes is nullptr then, while
    /// childTree's box still holds.
    uint32_t childCount;
    /// Of a scene, not 0: of hits at equal distance the last one counts, not the first.
    uint32_t lastOfEqual;
    /// nullptr unless rays are to ask for the view to walk. All but the tree and records is here.
    const DeferredView* deferred;
};

/// The box of a model's own triangles.
inline const BoxView& triangleBox(const ModelView& model) {
    return model.tree.nodes ? static_cast<const BoxView&>(model.tree) : model.wide;
}

} // namespace smart
