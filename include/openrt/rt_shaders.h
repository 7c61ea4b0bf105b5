/* SPDX-License-Identifier: MIT */
/* Shader classes, shaders and their parameters. Part of openrt/rt.h; how shaders are written is in
 * openrt/rts.h (C) and openrt/shader.hpp (C++).
 * A class says what is computed and which parameters there are; a shader is a class with values.
 * Shader 0 is the default surface: OpenGL's fixed function, at the start the current colour. */
#ifndef OPENRT_RT_SHADERS_H
#define OPENRT_RT_SHADERS_H

#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

struct RTshaderclass;

/* Finds a shader class by its name: in the shader library `fileName`, or if that is NULL one that
 * is built in or registered by rtRegisterShaderClass. Binds the class and shader 0. Every call
 * gives a new id. RT_INVALID on error. A file name with a slash is a path; any other is looked for
 * in the folders of the environment variable OPENRT_SHADER_PATH (separated by colons, ignored in
 * set-uid programs), then in the installed folder openrt/shaders beside this library, and never in
 * the current folder by itself. ".so" may be left out. The file is examined before any of its code
 * runs. It stays loaded until its classes and all that uses them are gone: ids, shaders, objects,
 * frames. How shader libraries are written is in rts_plugin.h (C) and plugin.hpp (C++).
 * Errors:  RT_INVALID_VALUE  shaderName NULL or unknown; the file is missing, no shader library, for
 *                            another machine or version, has no such class, or its constructor
 *                            fails: the text says which file and why. Nothing else happens then
 * Threads: the context's. Since: 0.1 */
RTAPI RTuint RTAPIENTRY rtGenNewShaderClass(const char *shaderName, const char *fileName);

/* Names of shader classes: in alphabetical order, each followed by a line feed; those of a shader
 * library, found and examined as by rtGenNewShaderClass, or with NULL the built-in ones. The text
 * lives until the next call of this function on the thread. NULL on error.
 * Errors:  RT_INVALID_VALUE  the file is missing or no shader library that can be used
 * Threads: the context's. Since: 0.1 */
RTAPI const char *RTAPIENTRY rtGetShaderClassNames(const char *fileName);

/* What a shader class is: its kind, parameters and functions, as rts.h has them. Lives as long as
 * the class: until its id is removed and its shaders are gone. NULL on error.
 * Errors:  RT_INVALID_VALUE  unknown class
 * Threads: the context's. Since: 0.1 */
RTAPI const struct RTshaderclass *RTAPIENTRY rtGetShaderClassDescriptor(RTuint shaderClass);

/* Makes a class that is part of the program known to this context. Returns its id, bound as by
 * rtGenNewShaderClass, which finds it by its name. The descriptor is copied; the functions in it
 * must stay where they are. A later class of the same name hides an earlier one from
 * rtGenNewShaderClass.
 * Errors:  RT_INVALID_VALUE  descriptor NULL, or the text says what is wrong with it
 * Threads: the context's. Since: 0.1 */
RTAPI RTuint RTAPIENTRY rtRegisterShaderClass(const struct RTshaderclass *descriptor);

/* Binds a shader class, and shader 0. 0 binds no class.
 * Errors:  RT_INVALID_VALUE  unknown class
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtBindShaderClass(RTuint shaderClass);

/* Forgets the id of a shader class; its shaders, and the classes of the same name, stay. Unbinds it
 * if bound.
 * Errors:  RT_INVALID_VALUE  unknown class
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtRemoveShaderClass(RTuint shaderClass);

/* A new shader of the bound class, with the class's defaults; binds it. RT_INVALID on error.
 * Errors:  RT_INVALID_OPERATION  no class bound
 * Threads: the context's. Since: 0.1 */
RTAPI RTuint RTAPIENTRY rtGenNewShader(void);

/* Binds a shader and its class: triangles from here on use it. 0 binds the default surface and no
 * class. A triangle's shader is the one bound when its last vertex is given.
 * Errors:  RT_INVALID_VALUE  unknown shader
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtBindShader(RTuint shader);

/* Forgets the id of a shader; objects, frames and this frame's lights that use the shader keep it.
 * If it was bound, shader 0 is bound now; the bound class stays.
 * Errors:  RT_INVALID_VALUE  unknown shader, or 0
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtRemoveShader(RTuint shader);

/* Handle of a parameter of the bound class, by name. Handles are unique over all classes and stay
 * good when another class is bound. RT_INVALID on error.
 * Errors:  RT_INVALID_OPERATION  no class bound
 *          RT_INVALID_VALUE      name NULL or no parameter of the class
 * Threads: the context's. Since: 0.1 */
RTAPI RTuint RTAPIENTRY rtParameterHandle(const char *name);

/* Sets a parameter of the bound shader. The type must be the declared one: a colour is 3f, bool
 * and texture ids are 1i, a matrix is 16f (column-major). The class declared when it counts:
 *   per shader    for every triangle of the shader, in frames started from now on
 *   per triangle  latched by the vertex that completes the triangle (the fourth of a quad)
 *   per vertex    latched by rtVertex, interpolated; floats only
 * Legal everywhere. Values last.
 * Errors:  RT_INVALID_VALUE      unknown handle, NULL
 *          RT_INVALID_OPERATION  no shader of the handle's class is bound, or another type
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtParameter1i(RTuint handle, RTint x);
RTAPI void RTAPIENTRY rtParameter2i(RTuint handle, RTint x, RTint y);
RTAPI void RTAPIENTRY rtParameter3i(RTuint handle, RTint x, RTint y, RTint z);
RTAPI void RTAPIENTRY rtParameter1f(RTuint handle, RTfloat x);
RTAPI void RTAPIENTRY rtParameter2f(RTuint handle, RTfloat x, RTfloat y);
RTAPI void RTAPIENTRY rtParameter3f(RTuint handle, RTfloat x, RTfloat y, RTfloat z);
RTAPI void RTAPIENTRY rtParameter4f(RTuint handle, RTfloat x, RTfloat y, RTfloat z, RTfloat w);
RTAPI void RTAPIENTRY rtParameter16f(RTuint handle, RTfloat m0, RTfloat m1, RTfloat m2, RTfloat m3,
                                     RTfloat m4, RTfloat m5, RTfloat m6, RTfloat m7, RTfloat m8,
                                     RTfloat m9, RTfloat m10, RTfloat m11, RTfloat m12, RTfloat m13,
                                     RTfloat m14, RTfloat m15);
RTAPI void RTAPIENTRY rtParameter1fv(RTuint handle, const RTfloat *v);
RTAPI void RTAPIENTRY rtParameter2fv(RTuint handle, const RTfloat *v);
RTAPI void RTAPIENTRY rtParameter3fv(RTuint handle, const RTfloat *v);
RTAPI void RTAPIENTRY rtParameter4fv(RTuint handle, const RTfloat *v);
RTAPI void RTAPIENTRY rtParameter16fv(RTuint handle, const RTfloat *v);

/* Sets a parameter of plain bytes of the bound shader: as rtParameter1i does. `size` must be the
 * declared one; the bytes are copied. Legal everywhere.
 * Errors:  RT_INVALID_VALUE      unknown handle, data NULL
 *          RT_INVALID_OPERATION  no shader of the handle's class is bound, another type, or another
 *                                size
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtParameterRaw(RTuint handle, const void *data, RTuint size);

/* Sets a string parameter of the bound shader: as rtParameter1i does. The text is copied. Legal
 * everywhere.
 * Errors:  RT_INVALID_VALUE      unknown handle, text NULL
 *          RT_INVALID_OPERATION  no shader of the handle's class is bound, or another type
 * Threads: the context's. Since: 0.1 */
RTAPI void RTAPIENTRY rtParameterString(RTuint handle, const char *text);

#ifdef __cplusplus
}
#endif
#endif
