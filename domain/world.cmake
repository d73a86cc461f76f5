set(world_headers)
foreach(header IN ITEMS
    action camera concept image image_quality input_error listed object object_crop symbol_key symbols
    task workbench world
    dataset/concept_dataset dataset/concept_dataset_writer dataset/dataset_state dataset/dataset_summary
    dataset/task_dataset dataset/task_dataset_writer
    simulation/concept_set simulation/judgement simulation/random_stream
    simulation/reference_planner simulation/second_target simulation/simulator simulation/task_generator)
  list(APPEND world_headers include/conceptplan/domain/${header}.hpp)
endforeach()

set(world_sources
  src/action.cpp
  src/camera.cpp
  src/concept.cpp
  src/image_quality.cpp
  src/input_error.cpp
  src/listed.cpp
  src/object.cpp
  src/object_crop.cpp
  src/symbol_key.cpp
  src/symbols.cpp
  src/task.cpp
  src/dataset/concept_dataset.cpp
  src/dataset/concept_dataset_writer.cpp
  src/dataset/concept_shard.cpp
  src/dataset/dataset_state.cpp
  src/dataset/dataset_summary.cpp
  src/dataset/manifest.cpp
  src/dataset/mapped_file.cpp
  src/dataset/task_dataset.cpp
  src/dataset/task_dataset_writer.cpp
  src/dataset/task_record.cpp
  src/simulation/concept_set.cpp
  src/simulation/judgement.cpp
  src/simulation/random_stream.cpp
  src/simulation/reference_planner.cpp
  src/simulation/second_target.cpp
  src/simulation/simulator.cpp
  src/simulation/task_generator.cpp)
