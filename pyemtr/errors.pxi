# Turns statuses of the C library into Python exceptions.

cdef int check(emtr_status status) except -1:
    if status == EMTR_OK:
        return 0
    text = emtr_error_message().decode("utf-8", "replace")
    if not text:
        text = emtr_status_text(status).decode()
    if status in (EMTR_ERROR_ARGUMENT, EMTR_ERROR_SETTING, EMTR_ERROR_CLOUD):
        raise ValueError(text)
    if status == EMTR_ERROR_MEMORY:
        raise MemoryError(text)
    raise RuntimeError(text)
