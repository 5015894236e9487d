# emtr_settings, read and written by name.

SETTING_TYPES = {EMTR_SETTING_INTEGER: "integer", EMTR_SETTING_REAL: "real",
                 EMTR_SETTING_SWITCH: "switch", EMTR_SETTING_CHOICE: "choice"}


def preset_names():
    """Returns the names of the presets in the library's order."""
    names = []
    cdef const char* name = emtr_preset_name(0)
    while name != NULL:
        names.append(name.decode())
        name = emtr_preset_name(len(names))
    return names


def describe_settings():
    """Returns for each setting (name, type, unit, minimum, maximum, value, part, text, choices)."""
    cdef emtr_setting_info info
    found = []
    for index in range(emtr_setting_count()):
        check(emtr_setting_describe(index, &info, sizeof(info)))
        found.append((info.name.decode(), SETTING_TYPES[info.type], info.unit.decode(),
                      info.minimum, info.maximum, info.value, info.part.decode(),
                      info.text.decode(), info.choices.decode()))
    return found


@cython.final
cdef class Settings:
    """Holds the settings of a preset and lets them be changed by name."""
    cdef emtr_settings values
    cdef const int32_t[:, ::1] pairs  # owns what values.correspondences points to

    def __init__(self, str preset not None):
        check(emtr_settings_init(&self.values, sizeof(emtr_settings), preset.encode()))

    def set(self, str name not None, double value):
        check(emtr_setting_set(&self.values, name.encode(), value))

    def get(self, str name not None):
        cdef double value = 0
        check(emtr_setting_get(&self.values, name.encode(), &value))
        return value

    @property
    def seed(self):
        return self.values.seed

    @seed.setter
    def seed(self, uint64_t value):
        self.values.seed = value

    @property
    def guess(self):
        """16 numbers, row-major, or None."""
        if not self.values.has_guess:
            return None
        return listed(self.values.guess, 16)

    @guess.setter
    def guess(self, const double[::1] value):
        if value.shape[0] != 16:
            raise ValueError("guess: 16 numbers are expected")
        for i in range(16):
            self.values.guess[i] = value[i]
        self.values.has_guess = 1

    @property
    def viewpoint_source(self):
        """3 numbers, or None."""
        if not self.values.has_viewpoint_source:
            return None
        return listed(self.values.viewpoint_source, 3)

    @viewpoint_source.setter
    def viewpoint_source(self, const double[::1] value):
        place(value, self.values.viewpoint_source)
        self.values.has_viewpoint_source = 1

    @property
    def viewpoint_target(self):
        """3 numbers, or None."""
        if not self.values.has_viewpoint_target:
            return None
        return listed(self.values.viewpoint_target, 3)

    @viewpoint_target.setter
    def viewpoint_target(self, const double[::1] value):
        place(value, self.values.viewpoint_target)
        self.values.has_viewpoint_target = 1

    @property
    def axis(self):
        """3 numbers, or None."""
        if not self.values.has_axis:
            return None
        return listed(self.values.axis, 3)

    @axis.setter
    def axis(self, const double[::1] value):
        place(value, self.values.axis)
        self.values.has_axis = 1

    @property
    def translation_bounds(self):
        """The smallest and the largest translation, 3 numbers each, or None."""
        if not self.values.has_translation_bounds:
            return None
        return [listed(self.values.translation_minimum, 3),
                listed(self.values.translation_maximum, 3)]

    @translation_bounds.setter
    def translation_bounds(self, const double[:, ::1] value):
        if value.shape[0] != 2:
            raise ValueError("translation_bounds: 2 rows are expected")
        place(value[0], self.values.translation_minimum)
        place(value[1], self.values.translation_maximum)
        self.values.has_translation_bounds = 1

    @property
    def correspondences(self):
        """The number of pairs, or None."""
        return None if self.values.correspondences == NULL else self.values.correspondence_count

    @correspondences.setter
    def correspondences(self, const int32_t[:, ::1] value):
        if value.shape[0] == 0 or value.shape[1] != 2:
            raise ValueError("correspondences: int32 of shape (k, 2), k > 0, is expected")
        self.pairs = value
        self.values.correspondences = &value[0, 0]
        self.values.correspondence_count = value.shape[0]


cdef list listed(const double* values, size_t count):
    return [values[i] for i in range(count)]


cdef int place(const double[::1] value, double* point) except -1:
    if value.shape[0] != 3:
        raise ValueError("a vector: 3 numbers are expected")
    for i in range(3):
        point[i] = value[i]
    return 0
