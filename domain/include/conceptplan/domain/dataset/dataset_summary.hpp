#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {

/// What is in a dataset, in figures.
struct DatasetSummary {
  std::string kind;  ///< "tasks" or "concepts"

  /// Option and value as in dataset.json, e.g. "split": "test".
  std::map<std::string, std::string> options;

  std::size_t tasks = 0;   ///< 0 in a concept dataset
  double mean_length = 0;  ///< of the references; 0 without tasks
  std::size_t max_length = 0;
  std::vector<std::size_t> length_histogram;   ///< tasks by length of their reference, from 0
  std::size_t images = 0;                      ///< RGB-D pictures, or crops
  std::map<std::string, std::size_t> objects;  ///< objects by type: in all tasks, or pictured
  std::map<std::string, std::size_t> splits;   ///< tasks or crops by split
  bool checksums_ok = false;                   ///< every file is there and as it was written
  std::vector<Fault> faults;                   ///< the files that are not
};

/// Reads a dataset of either kind and checks the checksum of every file. What is damaged is a fault
/// of the summary, and the figures cover what could be read.
/// @throws InputError if the folder is no dataset, of another version, or was interrupted.
DatasetSummary describeDataset(const std::filesystem::path& folder);

}  // namespace conceptplan
