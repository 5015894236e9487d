#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cli {

struct CloudFile;

/// A format of files that clouds come in.
struct Format {
  const char* extension;             ///< in lower case, with the dot; also the format's name
  const char* meaning;               ///< for --help-all
  bool (*begins)(std::string_view);  ///< tells whether a file may begin with these bytes
  void (*read)(CloudFile&);          ///< fills in the cloud from its place
  bool written = false;              ///< --aligned writes it
  bool with_faces = false;           ///< and keeps the faces of a mesh
  bool for_any_text = false;         ///< other text files have this extension too
};

/// Returns all formats. Help, messages and the choice of a reader come from this one table.
const std::vector<Format>& formats();

/// Returns the format of this extension or name, "ply" or ".PLY", or null.
const Format* find_format(const std::string& name);

/// Returns the format that a path is named like, ".gz" apart, or null.
const Format* format_of(const std::string& path);

/// Returns the first format that a file with this beginning may have, or null.
const Format* guess_format(std::string_view beginning);

/// Returns the extensions that are read, ".pcd, .ply or .obj", to end a sentence.
std::string read_extensions();

/// Returns the extensions that --aligned writes.
std::string written_extensions();

}  // namespace cli
