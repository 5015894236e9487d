# Lets a call that holds no GIL hear from Python: a run through its progress callback, any other
# call through this thread's interrupt function.

@cython.final
cdef class Watch:
    """Carries the user's callback to on_progress, and back what the callback raised."""
    cdef object callback
    cdef object error

    def __init__(self, callback):
        self.callback = callback


cdef int on_progress(const emtr_progress* progress, void* user) noexcept with gil:
    # Installed with or without a user's callback, because it makes Ctrl-C work.
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
    """Lets Ctrl-C end a call that takes no callback; holds what the signal handler raised."""
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
