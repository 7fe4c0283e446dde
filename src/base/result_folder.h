// A folder of results that is replaced as a whole: a run writes into a folder inside it and takes the place of the former
// result when it is finished. At any moment DIR holds one complete result, or none, and beside it a folder that says what is
// unfinished.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

class ResultFolder {
 public:
  // Makes the folder where it is absent. resume: what an unfinished run left there is kept, else it is dropped. Throws Error
  // where the folder cannot be written, or another run writes into it.
  ResultFolder(std::filesystem::path folder, bool resume);
  // Drops a run that has no line yet; leaves another as unfinished.
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  // Where the run writes: results.jsonl, images/, report.html; also a folder of results by itself, for `gnomon report`.
  const std::filesystem::path& unfinished() const { return unfinished_; }

  // Hands out the kept line that equals `line` in all of `keys` and whose pictures are all there; nullopt: to be measured.
  std::optional<nlohmann::json> take_kept(const nlohmann::json& line, std::span<const char* const> keys);
  size_t kept_count() const { return kept_.size(); }

  // Adds a line; the file on disk is whole after each.
  void add(nlohmann::json line);
  const std::vector<nlohmann::json>& lines() const { return lines_; }

  // After the last line: drops kept lines that nobody took and pictures that no line names. What is to be written beside the
  // lines (the report) can be made now.
  void complete();
  // The finished run takes the place of the former result, whose lines, pictures and report go. Files that are no part of a
  // result stay.
  void publish();

 private:
  class Lock {
   public:
    explicit Lock(const std::filesystem::path& folder);
    ~Lock();
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

   private:
    int file_;
  };
  struct Made {
    explicit Made(const std::filesystem::path& folder);
    bool anew;
  };

  void read_kept();
  void write_lines() const;

  std::filesystem::path folder_, unfinished_;
  Made made_;
  Lock lock_;
  std::vector<nlohmann::json> lines_, kept_;
  bool published_ = false;
};

// What a folder says about runs that did not finish.
struct UnfinishedRun {
  std::filesystem::path folder;
  size_t lines = 0;
};
std::optional<UnfinishedRun> unfinished_run(const std::filesystem::path& folder);

// Completes the replacement of a result that was cut off in the middle; nothing to do is fine. Called before a folder is read.
void settle_results(const std::filesystem::path& folder);

}  // namespace gnomon
