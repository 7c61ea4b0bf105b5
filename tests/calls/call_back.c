/* SPDX-License-Identifier: MIT */
/* A callback that takes no notice of its arguments; in C, where that is nobody's concern. */
void callBack(void);
void callBack(void) {}
