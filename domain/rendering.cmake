find_package(embree 3.13 REQUIRED)

conceptplan_library(rendering
  HEADERS
    include/conceptplan/domain/rendering/appearance.hpp
    include/conceptplan/domain/rendering/contact_sheet.hpp
    include/conceptplan/domain/rendering/renderer.hpp
  SOURCES
    src/rendering/appearance.cpp
    src/rendering/color.cpp
    src/rendering/contact_sheet.cpp
    src/rendering/food_models.cpp
    src/rendering/kitchenware_models.cpp
    src/rendering/light.cpp
    src/rendering/look.cpp
    src/rendering/material.cpp
    src/rendering/mesh.cpp
    src/rendering/object_geometry.cpp
    src/rendering/placed_object.cpp
    src/rendering/renderer.cpp
    src/rendering/room.cpp
    src/rendering/scene.cpp
    src/rendering/texture.cpp
    src/rendering/triangle_scene.cpp
  PUBLIC conceptplan::domain
  PRIVATE embree opencv_core opencv_imgproc)
