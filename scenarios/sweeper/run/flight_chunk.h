#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/sweeper/run/process_pool.h"

namespace touchdown::sweeper {

/// Flights of one cluster task, stored in a file.
struct FlightChunk {
  std::string program = {};  ///< Digest of the program that planned them.
  std::vector<FlightTask> flights = {};
};

/// File of chunk `number` in the output directory of the sweep.
std::filesystem::path ChunkFile(const std::filesystem::path& folder, int number);

/// Writes a chunk file. Throws InputError if it cannot be written.
void WriteChunk(const std::filesystem::path& file, const FlightChunk& chunk);

/// Flies the flights of a chunk that have no row in `folder` yet, at most `jobs` concurrently, and writes their rows
/// and images there. Several programs may work in `folder` at the same time, even on the same chunk. Returns false if a
/// stop was requested before all flights started. Throws InputError if the chunk does not exist or was planned by
/// another build, or if `folder` cannot be written.
bool FlyChunk(const std::filesystem::path& folder, int number, int jobs, const util::StopRequested& stop_requested,
              const OnRow& on_row);

}  // namespace touchdown::sweeper
