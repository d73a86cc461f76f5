find_package(ZLIB REQUIRED)

set(files_headers
  include/conceptplan/domain/files/atomic_file.hpp
  include/conceptplan/domain/files/checksum.hpp
  include/conceptplan/domain/files/rgbd_image_file.hpp)
set(files_sources
  src/files/atomic_file.cpp
  src/files/checksum.cpp
  src/files/png_format.cpp
  src/files/rgbd_image_file.cpp)
