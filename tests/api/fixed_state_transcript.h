/* SPDX-License-Identifier: MIT */
/* What a library of OpenGL's calls answers: after each call of a section its error, and all of the
 * state that changed. Compiled once with OpenGL's headers and once with openrt/gl.h. */
#ifndef OPENRT_TESTS_API_FIXED_STATE_TRANSCRIPT_H
#define OPENRT_TESTS_API_FIXED_STATE_TRANSCRIPT_H

#ifdef __cplusplus
extern "C" {
#endif

typedef void (*TranscriptLine)(void *user, const char *text);

enum { STATE_SECTIONS = 15 };
extern const char *const stateSectionNames[STATE_SECTIONS];

/* In a new context. */
void transcribeMesa(int section, TranscriptLine line, void *user);
void transcribeLibrary(int section, TranscriptLine line, void *user);

#ifdef __cplusplus
}
#endif
#endif
