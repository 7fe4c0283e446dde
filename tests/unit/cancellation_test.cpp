// Loading is given up from another thread: soon, and everywhere that it takes its time.
#include <gtest/gtest.h>

#include <atomic>

#include "base/file.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "scene/finish_part.h"
#include "scene/load.h"
#include "scene/parallel.h"

namespace gnomon {
namespace {

struct Heeding {
  explicit Heeding(const Cancellation& cancellation) { Cancellation::heed(&cancellation); }
  ~Heeding() { Cancellation::heed(nullptr); }
};

TEST(Cancellation, counts_for_the_thread_that_heeds_it) {
  Cancellation cancellation;
  {
    const Heeding heeding(cancellation);
    EXPECT_NO_THROW(check_cancelled());
    cancellation.cancel();
    EXPECT_THROW(check_cancelled(), Interrupted);
    std::jthread([] { EXPECT_NO_THROW(check_cancelled()); });
  }
  EXPECT_NO_THROW(check_cancelled());
}

TEST(Cancellation, reaches_every_step_of_loading) {
  Cancellation cancellation;
  cancellation.cancel();
  const Heeding heeding(cancellation);
  Progress progress("reading", 100);
  EXPECT_THROW(progress.update(1), Interrupted);
  EXPECT_THROW(read_file("/proc/self/exe"), Interrupted);
  EXPECT_THROW(load_obj_from_memory("v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n", "triangle.obj", {}), Interrupted);
  MeshPart part;
  part.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  part.indices = {0, 2, 1};
  EXPECT_THROW(finish_part(part), Interrupted);
}

TEST(Cancellation, ends_what_helps_the_thread) {
  Cancellation cancellation;
  const Heeding heeding(cancellation);
  Progress progress("work", 1000);
  std::atomic<int> done = 0;
  const auto work = [&](size_t) { ++done, cancellation.cancel(); };
  EXPECT_THROW(parallel_for(1000, progress, work), Interrupted);
  EXPECT_LE(done, static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u))) << "each thread may have begun one";
}

}  // namespace
}  // namespace gnomon
