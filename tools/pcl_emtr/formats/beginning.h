#pragma once

#include <string_view>

namespace cli {

// Each tells whether a file of the format may begin with these bytes. A stream without an extension
// is recognized by them, and an endless device is refused.

bool begins_pcd(std::string_view bytes);
bool begins_ply(std::string_view bytes);
bool begins_obj(std::string_view bytes);
bool begins_stl(std::string_view bytes);
bool begins_off(std::string_view bytes);
bool begins_npy(std::string_view bytes);
bool begins_las(std::string_view bytes);
bool begins_e57(std::string_view bytes);
bool begins_text(std::string_view bytes);

}  // namespace cli
