# Turns an emtr_result into plain Python values, by the library's own description of its fields.

FIELD_TYPES = {EMTR_FIELD_REAL: "real", EMTR_FIELD_INT32: "int32", EMTR_FIELD_SWITCH: "switch",
               EMTR_FIELD_SIZE: "size", EMTR_FIELD_UINT64: "uint64", EMTR_FIELD_TEXT: "text",
               EMTR_FIELD_REASON: "reason", EMTR_FIELD_ALTERNATIVE: "alternative"}


def describe_result():
    """Returns for each field (name, group, key, type, rows, columns)."""
    cdef emtr_result_field_info info
    found = []
    for index in range(emtr_result_field_count()):
        check(emtr_result_field_describe(index, &info, sizeof(info)))
        found.append((info.name.decode(), info.group.decode(), info.key.decode(),
                      FIELD_TYPES[info.type], info.rows, info.columns))
    return found


cdef dict fields(const emtr_result* result):
    cdef emtr_result_field_info info
    values = {}
    for index in range(emtr_result_field_count()):
        check(emtr_result_field_describe(index, &info, sizeof(info)))
        values[info.name.decode()] = field(&info, <const char*>result)
    return values


cdef object field(const emtr_result_field_info* info, const char* result):
    cdef const char* values = result + info.offset
    cdef size_t count = info.rows * info.columns
    if info.columns == 0:
        count = (<const size_t*>(result + info.count_offset))[0]
        values = (<const char* const*>values)[0]
    elif count == 1:
        return element(info.type, values, 0)
    return [element(info.type, values, i) for i in range(count)]


cdef object element(emtr_field_type type, const char* values, size_t i):
    cdef emtr_reason reason
    cdef int32_t number
    if type == EMTR_FIELD_REAL:
        return (<const double*>values)[i]
    if type == EMTR_FIELD_INT32:
        number = (<const int32_t*>values)[i]
        return None if number < 0 else number
    if type == EMTR_FIELD_SWITCH:
        return (<const int32_t*>values)[i] != 0
    if type == EMTR_FIELD_SIZE:
        return (<const size_t*>values)[i]
    if type == EMTR_FIELD_UINT64:
        return (<const uint64_t*>values)[i]
    if type == EMTR_FIELD_TEXT:
        return (<const char* const*>values)[i].decode()
    if type == EMTR_FIELD_REASON:
        reason = (<const emtr_reason*>values)[i]
        return emtr_reason_name(reason).decode(), emtr_reason_text(reason).decode()
    if type == EMTR_FIELD_ALTERNATIVE:
        return alternative(&(<const emtr_alternative*>values)[i])
    raise RuntimeError(f"a result field of the unknown type {type}")


cdef tuple alternative(const emtr_alternative* pose):
    return (listed(pose.transformation, 16), pose.score, pose.surface_fit, pose.violation,
            pose.evidence)


cdef dict finish(emtr_status status, Watch watch, emtr_result* result):
    # An exception of the callback comes first, because it ended the run.
    try:
        if watch.error is not None:
            raise watch.error
        check(status)
        return fields(result)
    finally:
        emtr_result_free(result)
