// SPDX-License-Identifier: MIT
#pragma once

namespace smart::compat {

/// Where the program was started several times to render together (by mpirun), connects these
/// processes: one of them is the application, the others work for it. In the first call only; for
/// rtInit, before it makes a context. Where that can not be, the process renders alone.
void joinOtherProcesses() noexcept;

/// In a process that works for another: makes that one's calls from now on, renders what it is
/// asked for, and ends the process when the other leaves. Otherwise, and where that is under way
/// already, it does nothing.
void serveOtherProcess() noexcept;

} // namespace smart::compat
