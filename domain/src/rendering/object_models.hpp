#pragma once

#include "conceptplan/domain/object.hpp"
#include "rendering/mesh.hpp"

namespace conceptplan::rendering {

/// The mesh of an object type at its largest size and rotation 0, standing on z = 0 about the z
/// axis, metres. It fits a footprint of 0.17 m square and a height of 0.15 m. The feature that
/// tells its rotations apart lies towards +x.
Mesh objectModel(ObjectType type);

/// @name One model each
/// @{
Mesh breadModel();
Mesh cupModel();
Mesh eggModel();
Mesh lettuceModel();
Mesh plateModel();
Mesh tomatoModel();
Mesh potModel();
Mesh dyerModel();
Mesh cellphoneModel();
Mesh dishSpongeModel();
Mesh saltshakerModel();
Mesh potatoModel();
/// @}

}  // namespace conceptplan::rendering
