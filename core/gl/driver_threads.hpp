// How many threads a driver that works on the processor uses.
#pragma once

namespace meltpool::gl {

/// On two processors or fewer: has Mesa's software driver work on the threads that call it, unless the person has said
/// otherwise (LP_NUM_THREADS). To share each of a weld's many small dispatches among further threads costs more than it
/// gains; wide ones and pictures without steps beside them gain. To be called before anything of OpenGL.
void spareDriverThreads();

/// Whether that driver, if it is the one in use, works on the threads that call it.
bool driverThreadsSpared();

} // namespace meltpool::gl
