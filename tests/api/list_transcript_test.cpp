// SPDX-License-Identifier: MIT
// Programs of display lists and vertex arrays on the library and on Mesa's off-screen OpenGL: what
// queries answer, and which errors there are, must be the same.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "openrt/rt.h"

namespace {

// Each program is written once, in names that both interfaces give a meaning.
struct Mesa {
#define CALL(name) static constexpr auto name = &gl##name
#include "list_transcript_calls.inc"
#undef CALL
    enum : unsigned {
        kCompile = GL_COMPILE, kCompileAndExecute = GL_COMPILE_AND_EXECUTE,
        kTriangles = GL_TRIANGLES, kQuads = GL_QUADS
    };
    static unsigned error() { return glGetError(); }
    Mesa() {
        context_ = OSMesaCreateContext(OSMESA_RGBA, nullptr);
        OSMesaMakeCurrent(context_, pixels_, GL_UNSIGNED_BYTE, 4, 4);
    }
    ~Mesa() {
        glFinish();
        OSMesaDestroyContext(context_);
    }
    Mesa(const Mesa&) = delete;
    Mesa& operator=(const Mesa&) = delete;

private:
    OSMesaContext context_;
    unsigned char pixels_[64];
};

struct OpenRt {
#define CALL(name) static constexpr auto name = &rt##name
#include "list_transcript_calls.inc"
#undef CALL
    enum : unsigned {
        kCompile = RT_COMPILE, kCompileAndExecute = RT_COMPILE_AND_EXECUTE,
        kTriangles = RT_TRIANGLES, kQuads = RT_QUADS
    };
    /// As OpenGL's token.
    static unsigned error() {
        switch (rtGetError()) {
        case RT_NO_ERROR: return GL_NO_ERROR;
        case RT_INVALID_ENUM: return GL_INVALID_ENUM;
        case RT_INVALID_VALUE: return GL_INVALID_VALUE;
        case RT_INVALID_OPERATION: return GL_INVALID_OPERATION;
        case RT_STACK_OVERFLOW: return GL_STACK_OVERFLOW;
        case RT_STACK_UNDERFLOW: return GL_STACK_UNDERFLOW;
        default: return GL_OUT_OF_MEMORY;
        }
    }
    OpenRt() { rtInit(nullptr, nullptr); }
    ~OpenRt() { rtExit(); }
    OpenRt(const OpenRt&) = delete;
    OpenRt& operator=(const OpenRt&) = delete;
};

template <class Api>
class Program : public Api {
public:
    /// Everything that can be asked, and the errors since the last time.
    void note(const char* where) {
        float color[4], normal[3], texCoord[4], matrix[16];
        int mode = 0, depth = 0;
        std::string errors;
        while (const unsigned error = Api::error()) errors.append(" ").append(std::to_string(error));
        Api::GetFloatv(GL_CURRENT_COLOR, color);
        Api::GetFloatv(GL_CURRENT_NORMAL, normal);
        Api::GetFloatv(GL_CURRENT_TEXTURE_COORDS, texCoord);
        Api::GetFloatv(GL_MODELVIEW_MATRIX, matrix);
        Api::GetIntegerv(GL_MATRIX_MODE, &mode);
        Api::GetIntegerv(GL_MODELVIEW_STACK_DEPTH, &depth);
        text_ << where << ": errors" << errors << ", color";
        for (const float v : color) text_ << ' ' << std::lround(v * 1e4f);
        text_ << ", normal";
        for (const float v : normal) text_ << ' ' << std::lround(v * 1e4f);
        text_ << ", texture";
        for (const float v : texCoord) text_ << ' ' << std::lround(v * 1e4f);
        text_ << ", matrix";
        for (const float v : matrix) text_ << ' ' << std::lround(v * 1e3f);
        text_ << ", mode " << mode << ", depth " << depth << '\n';
    }
    void note(const char* what, long value) { text_ << what << ' ' << value << '\n'; }
    std::string text() const { return text_.str(); }

private:
    std::ostringstream text_;
};

template <class Calls>
void compare(Calls&& calls) {
    Program<Mesa> mesa;
    calls(mesa);
    Program<OpenRt> openRt;
    calls(openRt);
    EXPECT_FALSE(mesa.text().empty());
    EXPECT_EQ(openRt.text(), mesa.text());
}

TEST(ListTranscript, Names) {
    compare([](auto& gl) {
        gl.note("first", gl.GenLists(5));
        gl.note("next", gl.GenLists(3));
        for (unsigned name = 0; name < 10; ++name) gl.note("is a list", gl.IsList(name));
        gl.DeleteLists(3, 3);
        for (unsigned name = 0; name < 10; ++name) gl.note("is a list", gl.IsList(name));
        gl.note("two more", gl.GenLists(2) != 0);
        gl.DeleteLists(1, 0);
        gl.DeleteLists(100, 50);
        gl.note("after deleting");
        gl.DeleteLists(1, -1);
        gl.note("negative range to delete");
        gl.note("none", gl.GenLists(0));
        gl.note("no error");
        gl.note("negative", gl.GenLists(-2));
        gl.note("negative range");
    });
}

TEST(ListTranscript, CompileExecuteReplace) {
    compare([](auto& gl) {
        gl.NewList(1, gl.kCompile);
        gl.Color3f(1, 0.5f, 0.25f);
        gl.Translatef(1, 2, 3);
        gl.note("while compiled");
        gl.EndList();
        gl.note("compiled");
        gl.CallList(1);
        gl.note("called");
        gl.NewList(1, gl.kCompileAndExecute);
        gl.Normal3f(1, 0, 0);
        gl.Rotatef(90, 0, 0, 1);
        gl.CallList(1); // still the old one
        gl.note("executed");
        gl.EndList();
        gl.LoadIdentity();
        gl.CallList(1); // the new one, which calls itself
        gl.note("called again");
    });
}

TEST(ListTranscript, ErrorsOfListing) {
    compare([](auto& gl) {
        gl.EndList();
        gl.note("no list");
        gl.NewList(0, gl.kCompile);
        gl.note("name 0");
        gl.NewList(1, 77);
        gl.note("mode");
        gl.NewList(1, gl.kCompile);
        gl.NewList(2, gl.kCompile);
        gl.note("two lists");
        gl.EndList();
        gl.note("one end");
        gl.EndList();
        gl.note("two ends");
        gl.Begin(gl.kTriangles);
        gl.NewList(3, gl.kCompile);
        gl.End();
        gl.note("between begin and end");
    });
}

TEST(ListTranscript, ErrorsAtReplay) {
    compare([](auto& gl) {
        gl.NewList(1, gl.kCompile);
        gl.MatrixMode(77);
        gl.Color3f(0.5f, 0.5f, 0.5f);
        gl.PopMatrix();
        gl.Begin(77);
        gl.End();
        gl.EndList();
        gl.note("compiled");
        gl.CallList(1);
        gl.note("called");
    });
}

TEST(ListTranscript, NestedToTheLimit) {
    compare([](auto& gl) {
        for (unsigned name = 1; name <= 80; ++name) {
            gl.NewList(name, gl.kCompile);
            gl.Translatef(1, 0, 0);
            gl.CallList(name + 1);
            gl.EndList();
        }
        gl.CallList(1);
        gl.note("64 levels");
        gl.LoadIdentity();
        gl.CallList(60);
        gl.note("fewer");
        gl.NewList(100, gl.kCompile);
        gl.Translatef(0, 1, 0);
        gl.CallList(100);
        gl.Translatef(0, 0, 1);
        gl.EndList();
        gl.LoadIdentity();
        gl.CallList(100);
        gl.note("a list that calls itself");
    });
}

TEST(ListTranscript, FoundByNameAtReplay) {
    compare([](auto& gl) {
        gl.NewList(1, gl.kCompile);
        gl.CallList(2);
        gl.Translatef(1, 0, 0);
        gl.EndList();
        gl.CallList(1);
        gl.note("unknown");
        gl.NewList(2, gl.kCompile);
        gl.Color3f(0, 1, 0);
        gl.EndList();
        gl.CallList(1);
        gl.note("known");
        gl.NewList(2, gl.kCompile);
        gl.Color3f(0, 0, 1);
        gl.EndList();
        gl.CallList(1);
        gl.note("replaced");
        gl.DeleteLists(2, 1);
        gl.Color3f(1, 1, 1);
        gl.CallList(1);
        gl.note("deleted");
    });
}

TEST(ListTranscript, NamesOfAllTypes) {
    compare([](auto& gl) {
        for (unsigned name = 1; name <= 300; ++name) {
            gl.NewList(name, gl.kCompile);
            gl.Translatef(float(name), 1, 0);
            gl.EndList();
        }
        const auto called = [&](const char* type) {
            gl.note(type);
            gl.LoadIdentity();
        };
        gl.ListBase(100);
        const signed char bytes[] = {-90, 5, 0};
        gl.CallLists(3, GL_BYTE, bytes);
        called("bytes");
        const unsigned char unsignedBytes[] = {199, 5, 0};
        gl.CallLists(3, GL_UNSIGNED_BYTE, unsignedBytes);
        called("unsigned bytes");
        const short shorts[] = {-99, 150, -98};
        gl.CallLists(2, GL_SHORT, shorts);
        called("shorts");
        const unsigned short unsignedShorts[] = {7, 150};
        gl.CallLists(2, GL_UNSIGNED_SHORT, unsignedShorts);
        called("unsigned shorts");
        const int ints[] = {-50, 150};
        gl.CallLists(2, GL_INT, ints);
        called("ints");
        const unsigned unsignedInts[] = {0xFFFFFFF0u, 150};
        gl.CallLists(2, GL_UNSIGNED_INT, unsignedInts);
        called("unsigned ints");
        const float floats[] = {-50.0f, 7.75f, 1e30f};
        gl.CallLists(2, GL_FLOAT, floats);
        called("floats");
        const unsigned char packed[] = {0, 0, 0, 120, 0, 0, 0, 7};
        gl.CallLists(4, GL_2_BYTES, packed);
        called("2 bytes");
        gl.CallLists(2, GL_3_BYTES, packed);
        called("3 bytes");
        gl.CallLists(2, GL_4_BYTES, packed);
        called("4 bytes");
        gl.CallLists(2, GL_DOUBLE, packed);
        called("no type");
        gl.CallLists(-1, GL_BYTE, bytes);
        called("negative");
        gl.NewList(400, gl.kCompile);
        gl.ListBase(50);
        gl.CallLists(2, GL_SHORT, shorts + 1);
        gl.EndList();
        gl.CallList(400);
        called("base in a list");
    });
}

TEST(ListTranscript, BeginAndEndInDifferentPlaces) {
    compare([](auto& gl) {
        gl.NewList(1, gl.kCompile);
        gl.Begin(gl.kQuads);
        gl.Color3f(1, 0, 0);
        gl.EndList();
        gl.NewList(2, gl.kCompile);
        gl.Vertex3f(0, 0, 0);
        gl.Color3f(0, 0.5f, 0);
        gl.Normal3f(0, 1, 0);
        gl.EndList();
        gl.NewList(3, gl.kCompile);
        gl.End();
        gl.EndList();
        gl.CallList(1);
        gl.CallList(2);
        gl.MatrixMode(GL_PROJECTION); // between begin and end
        gl.CallList(3);
        gl.note("three lists");
        gl.Begin(gl.kTriangles);
        gl.CallList(2);
        gl.End();
        gl.note("vertices in a list");
        gl.CallList(3);
        gl.note("an end too many");
    });
}

TEST(ListTranscript, CurrentValuesAfterARun) {
    compare([](auto& gl) {
        gl.NewList(1, gl.kCompile);
        gl.Color3f(1, 0, 0);
        gl.Begin(gl.kTriangles);
        gl.Normal3f(0, 1, 0);
        gl.Vertex3f(0, 0, 0);
        gl.Color4ub(51, 102, 204, 255);
        gl.Vertex3f(1, 0, 0);
        gl.TexCoord2f(0.25f, 0.5f);
        gl.Normal3f(1, 0, 0); // Mesa forgets what comes after the last vertex
        gl.Vertex3f(0, 1, 0);
        gl.End();
        gl.PushMatrix();
        gl.Scalef(2, 2, 2);
        gl.EndList();
        gl.CallList(1);
        gl.note("once");
        gl.Color3f(0, 0, 0);
        gl.CallList(1);
        gl.note("twice");
        gl.Scalef(1, 1, 0); // the run can not be placed now
        gl.Color3f(0, 0, 0);
        gl.CallList(1);
        gl.note("flat");
    });
}

TEST(ListTranscript, MatricesAreCopied) {
    compare([](auto& gl) {
        float m[16] = {1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0, 4, 5, 6, 1};
        gl.NewList(1, gl.kCompile);
        gl.LoadMatrixf(m);
        gl.MultMatrixf(m);
        gl.EndList();
        for (float& element : m) element = 9;
        gl.CallList(1);
        gl.note("as they were");
    });
}

TEST(ArrayTranscript, StateOfArrays) {
    compare([](auto& gl) {
        static const float data[64] = {};
        const unsigned names[] = {
            GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_TYPE, GL_VERTEX_ARRAY_STRIDE,
            GL_NORMAL_ARRAY_TYPE, GL_NORMAL_ARRAY_STRIDE, GL_COLOR_ARRAY_SIZE,
            GL_COLOR_ARRAY_TYPE, GL_COLOR_ARRAY_STRIDE, GL_TEXTURE_COORD_ARRAY_SIZE,
            GL_TEXTURE_COORD_ARRAY_TYPE, GL_TEXTURE_COORD_ARRAY_STRIDE,
            GL_EDGE_FLAG_ARRAY_STRIDE, GL_INDEX_ARRAY_TYPE, GL_INDEX_ARRAY_STRIDE,
            GL_FOG_COORD_ARRAY_TYPE, GL_SECONDARY_COLOR_ARRAY_SIZE,
            GL_SECONDARY_COLOR_ARRAY_TYPE, GL_ARRAY_BUFFER_BINDING,
            GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BUFFER_BINDING,
            GL_COLOR_ARRAY_BUFFER_BINDING};
        const unsigned arrays[] = {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY,
                                   GL_TEXTURE_COORD_ARRAY, GL_EDGE_FLAG_ARRAY, GL_INDEX_ARRAY,
                                   GL_FOG_COORD_ARRAY, GL_SECONDARY_COLOR_ARRAY};
        const auto ask = [&](const char* when) {
            for (const unsigned name : names) {
                int value = -1;
                gl.GetIntegerv(name, &value);
                gl.note("value", value);
            }
            for (const unsigned array : arrays) gl.note("enabled", gl.IsEnabled(array));
            void* pointer = nullptr;
            gl.GetPointerv(GL_COLOR_ARRAY_POINTER, &pointer);
            gl.note("colours at",
                    pointer ? long(static_cast<const float*>(pointer) - data) : -1);
            gl.note(when);
        };
        ask("start");
        gl.VertexPointer(3, GL_DOUBLE, 40, data);
        gl.NormalPointer(GL_SHORT, 8, data);
        gl.ColorPointer(3, GL_UNSIGNED_BYTE, 3, data + 1);
        gl.TexCoordPointer(1, GL_FLOAT, 0, data);
        gl.EdgeFlagPointer(5, data);
        gl.IndexPointer(GL_UNSIGNED_BYTE, 2, data);
        gl.FogCoordPointer(GL_DOUBLE, 0, data);
        gl.SecondaryColorPointer(3, GL_BYTE, 0, data);
        for (const unsigned array : arrays) gl.EnableClientState(array);
        ask("set");
        gl.DisableClientState(GL_NORMAL_ARRAY);
        gl.VertexPointer(5, GL_FLOAT, 0, data);
        gl.note("size");
        gl.VertexPointer(3, GL_UNSIGNED_BYTE, 0, data);
        gl.note("type");
        gl.VertexPointer(3, GL_FLOAT, -1, data);
        gl.note("stride");
        gl.NormalPointer(GL_UNSIGNED_SHORT, 0, data);
        gl.note("type of normals");
        gl.ColorPointer(2, GL_FLOAT, 0, data);
        gl.note("size of colours");
        gl.EnableClientState(GL_LIGHTING);
        gl.note("no array");
        gl.InterleavedArrays(77, 0, data);
        gl.note("no format");
        gl.DisableClientState(GL_FOG_COORD_ARRAY); // Mesa leaves these two as they are
        gl.DisableClientState(GL_SECONDARY_COLOR_ARRAY);
        for (unsigned format = GL_V2F; format <= GL_T4F_C4F_N3F_V4F; ++format) {
            gl.InterleavedArrays(format, format % 2 ? 0 : 80, data);
            ask("interleaved");
        }
    });
}

TEST(ArrayTranscript, ErrorsOfDrawing) {
    compare([](auto& gl) {
        static const float data[64] = {};
        static const unsigned char indices[] = {0, 1, 2};
        gl.VertexPointer(3, GL_FLOAT, 0, data);
        gl.EnableClientState(GL_VERTEX_ARRAY);
        gl.DrawArrays(77, 0, 3);
        gl.note("mode");
        gl.DrawArrays(gl.kTriangles, 0, -1);
        gl.note("count");
        gl.DrawElements(gl.kTriangles, 3, GL_FLOAT, indices);
        gl.note("type of indices");
        gl.DrawElements(gl.kTriangles, -3, GL_UNSIGNED_BYTE, indices);
        gl.note("number of indices");
        gl.DrawRangeElements(gl.kTriangles, 2, 0, 3, GL_UNSIGNED_BYTE, indices);
        gl.note("range");
        gl.Begin(gl.kTriangles);
        gl.DrawArrays(gl.kTriangles, 0, 3);
        gl.End();
        gl.note("between begin and end");
        gl.DrawArrays(gl.kTriangles, 0, 0);
        gl.DrawElements(gl.kTriangles, 3, GL_UNSIGNED_BYTE, indices);
        gl.note("right");
    });
}

TEST(ArrayTranscript, ElementsSetCurrentValues) {
    compare([](auto& gl) {
        static const unsigned char colors[] = {255, 0, 0, 51, 102, 204};
        static const short normals[] = {32767, 0, 0, 0, -32768, 0};
        static const float texCoords[] = {0.25f, 0.75f};
        gl.ColorPointer(3, GL_UNSIGNED_BYTE, 0, colors);
        gl.NormalPointer(GL_SHORT, 0, normals);
        gl.TexCoordPointer(1, GL_FLOAT, 0, texCoords);
        gl.EnableClientState(GL_COLOR_ARRAY);
        gl.ArrayElement(1);
        gl.note("colour");
        gl.EnableClientState(GL_NORMAL_ARRAY);
        gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
        gl.ArrayElement(0);
        gl.note("all");
        gl.NewList(1, gl.kCompile);
        gl.ArrayElement(1);
        gl.EndList();
        gl.note("in a list");
        gl.DisableClientState(GL_COLOR_ARRAY);
        gl.CallList(1);
        gl.note("from the list");
    });
}

TEST(ArrayTranscript, Buffers) {
    compare([](auto& gl) {
        unsigned names[3] = {};
        gl.GenBuffers(3, names);
        gl.note("a buffer", gl.IsBuffer(names[0]));
        gl.BindBuffer(GL_ARRAY_BUFFER, names[0]);
        gl.note("bound", gl.IsBuffer(names[0]));
        gl.BufferData(GL_ARRAY_BUFFER, -1, nullptr, GL_STATIC_DRAW);
        gl.note("size");
        gl.BufferData(GL_ARRAY_BUFFER, 16, nullptr, 77);
        gl.note("usage");
        gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, 16, nullptr, GL_STATIC_DRAW);
        gl.note("nothing bound");
        unsigned char data[16] = {1, 2, 3, 4, 5, 6, 7, 8};
        gl.BufferData(GL_ARRAY_BUFFER, 16, data, GL_DYNAMIC_COPY);
        gl.BufferSubData(GL_ARRAY_BUFFER, 14, 2, data);
        gl.GetBufferSubData(GL_ARRAY_BUFFER, 0, 16, data);
        for (const unsigned char byte : data) gl.note("byte", byte);
        gl.BufferSubData(GL_ARRAY_BUFFER, 15, 2, data);
        gl.note("behind the end");
        for (const unsigned name : {GL_BUFFER_SIZE, GL_BUFFER_USAGE, GL_BUFFER_ACCESS,
                                    GL_BUFFER_MAPPED}) {
            int value = -1;
            gl.GetBufferParameteriv(GL_ARRAY_BUFFER, name, &value);
            gl.note("value", value);
        }
        gl.UnmapBuffer(GL_ARRAY_BUFFER);
        gl.note("not mapped");
        auto* const mapped =
            static_cast<unsigned char*>(gl.MapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE));
        gl.note("mapped byte", mapped[3]);
        gl.MapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE);
        gl.note("mapped twice");
        gl.BufferSubData(GL_ARRAY_BUFFER, 0, 1, data);
        gl.note("written while mapped");
        gl.note("unmapped", gl.UnmapBuffer(GL_ARRAY_BUFFER));
        gl.DeleteBuffers(3, names);
        gl.note("deleted", gl.IsBuffer(names[0]));
        int binding = -1;
        gl.GetIntegerv(GL_ARRAY_BUFFER_BINDING, &binding);
        gl.note("bound still", binding);
        gl.note("at the end");
    });
}

} // namespace
