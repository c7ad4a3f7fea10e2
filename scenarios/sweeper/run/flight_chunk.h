#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/sweeper/run/process_pool.h"

namespace touchdown::sweeper {

/// Flights of a sweep for a program on another machine, stored in a file.
struct FlightChunk {
  std::string program = {};  ///< Digest of the program that planned them.
  std::vector<FlightTask> flights = {};
};

/// File of chunk `number` in the folder of the sweep.
std::filesystem::path ChunkFile(const std::filesystem::path& folder, int number);

void WriteChunk(const std::filesystem::path& file, const FlightChunk& chunk);

/// Flies the flights of a chunk that have no row in `folder` yet, at most `jobs` concurrently, and writes their rows
/// and images there. Several programs may run in the folder at once, even on the same chunk. Returns false when a stop
/// was requested before all were flown. Throws InputError when there is no such chunk, another build planned it, or
/// `folder` cannot be written.
bool FlyChunk(const std::filesystem::path& folder, int number, int jobs, const util::StopRequested& stop_requested,
              const OnRow& on_row);

}  // namespace touchdown::sweeper
