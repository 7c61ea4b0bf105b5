// SPDX-License-Identifier: MIT
// The functions of the interface as a table: what a call of each consists of. Written by
// generate_stream.py from the public headers and parameters.csv.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

namespace smart::compat {

/// A parameter or result of any type, as its bytes.
class CallValue {
public:
    CallValue() = default;
    template <class T>
    explicit CallValue(T value) {
        static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= sizeof bits_);
        std::memcpy(&bits_, &value, sizeof value);
    }
    template <class T>
    T as() const {
        T value;
        std::memcpy(&value, &bits_, sizeof value);
        return value;
    }

private:
    uint64_t bits_ = 0;
};

enum class ValueKind : uint8_t {
    Void, Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float, Double, Pointer
};
std::size_t bytesOf(ValueKind kind);

/// What a number or pointer names. Those from Object on are found anew by a player.
enum class Meaning : uint8_t {
    Plain,
    Token, ///< an enumeration; to be printed by name
    Name,  ///< that the application may choose: lists, textures, buffers
    Object, Shader, ShaderClass, ParameterHandle, Scene, ///< of a context
    Frame, QueryScene, Context, Quadric, Tessellator, Nurbs ///< of the process
};

/// What a pointer points to.
enum class Memory : uint8_t {
    None,
    Constant,   ///< `amount` elements
    Counted,    ///< `amount` elements for each that another parameter counts
    Token,      ///< as many values as a token has; of an unknown one none is looked at
    TokenOrOne, ///< the same; of an unknown one the first is looked at
    String, Arguments, ///< text; argc and argv of rtInit
    Image,             ///< of `amount` dimensions, as the unpack state says
    Bitmap, ///< a square of `amount` bits a side where the call does not say
    Lists,             ///< names of display lists, of a type
    Indices, ManyIndices, ///< in memory or in a buffer
    Array,             ///< a vertex array, or an offset in a buffer; read when it is drawn
    Rays, Hits,        ///< RTraystream, RThitstream
    PackedImage,       ///< as the pack state says; a square of bits as above
    ScaledImage,       ///< of rtuScaleImage
    Scratch,           ///< some values of state
    FrameBuffer, AuxBuffer,
    ShaderDescriptor,
    Callback,
    Unread ///< nothing looks at it
};

struct CallParameter {
    const char* name;
    const char* type; ///< in C
    ValueKind kind;
    ValueKind element; ///< of what a pointer points to; Void: bytes, or a structure
    Meaning meaning;
    Memory memory;
    bool isOutput;
    int16_t amount;
    int16_t counter; ///< number of the parameter that counts, or names the token; -1: none
    uint16_t elementBytes;
};

enum class CallKind : uint8_t {
    State,  ///< changes what later calls do
    Query,  ///< has results, and no effect
    Frame,  ///< starts a frame or waits for it
    Read    ///< needs the picture so far
};

/// What a call leaves in memory of the application that a played one has to leave too.
enum class Yield : uint8_t { Nothing, Names, Pixels };

inline constexpr std::size_t kMaxParameters = 17;

struct CallSignature {
    const char* name;
    uint16_t number;
    CallKind kind;
    Yield yield;
    ValueKind result;
    Meaning resultMeaning;
    bool comparesResult; ///< of a successful call, which has to have the same
    uint16_t firstParameter, parameters;
    uint32_t fingerprint; ///< of name and types
};

std::span<const CallSignature> callTable();
std::span<const CallParameter> parametersOf(const CallSignature& call);
/// nullptr: no such function.
const CallSignature* findCall(const char* name);
/// Calls a function of the interface; pointers are those of this process.
void invokeCall(const CallSignature& call, const CallValue* arguments, CallValue& result);

} // namespace smart::compat
