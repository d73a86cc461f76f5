find_package(ZLIB REQUIRED)

set(files_headers
  include/conceptplan/domain/files/atomic_file.hpp
  include/conceptplan/domain/files/checksum.hpp
  include/conceptplan/domain/files/json_depth.hpp
  include/conceptplan/domain/files/nearest_name.hpp
  include/conceptplan/domain/files/program_path.hpp
  include/conceptplan/domain/files/rgbd_image_file.hpp
  include/conceptplan/domain/scenario/reference.hpp
  include/conceptplan/domain/scenario/scenario.hpp
  include/conceptplan/domain/scenario/scenario_file.hpp)
set(files_sources
  src/files/atomic_file.cpp
  src/files/checksum.cpp
  src/files/json_depth.cpp
  src/files/nearest_name.cpp
  src/files/program_path.cpp
  src/files/png_format.cpp
  src/files/rgbd_image_file.cpp
  src/scenario/reference.cpp
  src/scenario/scenario.cpp
  src/scenario/scenario_reader.cpp
  src/scenario/scenario_writer.cpp
  src/scenario/yaml_map.cpp)
