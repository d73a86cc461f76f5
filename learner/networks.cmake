# The learned part that needs Torch: concept learner, symbolizer, ViCT and their training.
find_package(nlohmann_json 3.11 REQUIRED)

conceptplan_library(learner
  HEADERS
    include/conceptplan/learner/concept_learner.hpp
    include/conceptplan/learner/effect_context.hpp
    include/conceptplan/learner/encoder_input.hpp
    include/conceptplan/learner/encoder_kind.hpp
    include/conceptplan/learner/frame_composition.hpp
    include/conceptplan/learner/background.hpp
    include/conceptplan/learner/frame_window.hpp
    include/conceptplan/learner/kmeans.hpp
    include/conceptplan/learner/learned_symbols.hpp
    include/conceptplan/learner/symbolizer.hpp
    include/conceptplan/learner/tensor_file.hpp
    include/conceptplan/learner/tokens.hpp
    include/conceptplan/learner/torch/causal_transition.hpp
    include/conceptplan/learner/torch/checkpoint_identity.hpp
    include/conceptplan/learner/torch/concept_losses.hpp
    include/conceptplan/learner/torch/concept_network.hpp
    include/conceptplan/learner/torch/concept_trainer.hpp
    include/conceptplan/learner/torch/encoder_batch.hpp
    include/conceptplan/learner/torch/frame_synthesizer.hpp
    include/conceptplan/learner/torch/generator_guard.hpp
    include/conceptplan/learner/torch/module_tensors.hpp
    include/conceptplan/learner/torch/object_drawer.hpp
    include/conceptplan/learner/torch/token_tensors.hpp
    include/conceptplan/learner/torch/training_state.hpp
    include/conceptplan/learner/torch/vict_trainer.hpp
    include/conceptplan/learner/training/chain_sampler.hpp
    include/conceptplan/learner/training/augmentation.hpp
    include/conceptplan/learner/training/concept_images.hpp
    include/conceptplan/learner/training/task_sequences.hpp
    include/conceptplan/learner/visual_transition.hpp
  SOURCES
    src/effect_context.cpp
    src/encoder_input.cpp
    src/encoder_kind.cpp
    src/frame_composition.cpp
    src/background.cpp
    src/frame_window.cpp
    src/kmeans.cpp
    src/learned_symbols.cpp
    src/symbolizer.cpp
    src/tensor_file.cpp
    src/torch/causal_transition.cpp
    src/torch/checkpoint_identity.cpp
    src/torch/concept_learner.cpp
    src/torch/concept_losses.cpp
    src/torch/concept_network.cpp
    src/torch/concept_trainer.cpp
    src/torch/encoder_batch.cpp
    src/torch/frame_synthesizer.cpp
    src/torch/generator_guard.cpp
    src/torch/module_tensors.cpp
    src/torch/object_drawer.cpp
    src/torch/token_tensors.cpp
    src/torch/training_state.cpp
    src/torch/vict_trainer.cpp
    src/torch/visual_transition.cpp
    src/training/chain_sampler.cpp
    src/training/augmentation.cpp
    src/training/concept_images.cpp
  PUBLIC conceptplan::domain conceptplan::transitions torch
  PRIVATE nlohmann_json::nlohmann_json)
target_precompile_headers(conceptplan_learner PRIVATE <torch/torch.h>)
