# How a call that holds no GIL hears of Python again: by the progress callback of a run, else by
# this thread's interrupt.

@cython.final
cdef class Watch:
    """What on_progress needs: the user's callback, and room for what it raised."""
    cdef object callback
    cdef object error

    def __init__(self, callback):
        self.callback = callback


cdef int on_progress(const emtr_progress* progress, void* user) noexcept with gil:
    # Always installed, with or without a user's callback: it is what makes Ctrl-C work.
    cdef Watch watch = <Watch>user
    try:
        PyErr_CheckSignals()
        if watch.callback is None:
            return 0
        stop = watch.callback(progress.stage.decode(), progress.iteration, progress.iterations,
                              progress.best_alpha, progress.best_beta)
        return 1 if stop else 0
    except BaseException as error:  # C cannot be unwound: finish() raises it again
        watch.error = error
        return 1


@cython.final
cdef class Interrupt:
    """Around a call that takes no callback: Ctrl-C ends it, and here is what its handler raised."""
    cdef object error

    cdef void begin(self) noexcept:
        emtr_set_interrupt(on_interrupt, <void*>self)

    cdef int end(self, emtr_status status) except -1:
        emtr_set_interrupt(NULL, NULL)
        if self.error is not None:
            raise self.error
        return check(status)


cdef int on_interrupt(void* user) noexcept with gil:
    try:
        PyErr_CheckSignals()
        return 0
    except BaseException as error:  # end() raises it again
        (<Interrupt>user).error = error
        return 1
