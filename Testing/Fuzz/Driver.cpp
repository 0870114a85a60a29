/// Runs a fuzz target without a fuzzing engine, the same way each time: TARGET SECONDS SEED [FILE...]. Inputs are
/// random bytes or, where files are given, these with random changes. The target has the signature that libFuzzer
/// wants.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{
using Input = std::vector<std::uint8_t>;
using Random = std::mt19937_64;

constexpr std::size_t longest = 4096;

std::size_t below(Random& random, std::size_t end)
{
  return static_cast<std::size_t>(random() % std::max<std::size_t>(end, 1));
}

Input randomBytes(Random& random)
{
  Input input(below(random, longest));
  for (std::uint8_t& byte : input)
  {
    byte = static_cast<std::uint8_t>(random());
  }
  return input;
}

/// Changes, inserts, removes or repeats a few bytes.
Input changed(Input input, Random& random)
{
  for (std::size_t changes = 1 + below(random, 4); changes > 0 && !input.empty(); --changes)
  {
    const auto place = input.begin() + static_cast<std::ptrdiff_t>(below(random, input.size()));
    const auto end = place + static_cast<std::ptrdiff_t>(
                               below(random, std::min<std::size_t>(64, static_cast<std::size_t>(input.end() - place))));
    switch (random() % 4)
    {
      case 0:
        *place = static_cast<std::uint8_t>(random());
        break;
      case 1:
        input.insert(place, static_cast<std::uint8_t>("{}[]\",:-0e9.\\ntf"[random() % 16]));
        break;
      case 2:
        input.erase(place, end);
        break;
      default: {
        const Input part(place, end);
        input.insert(place, part.begin(), part.end());
      }
    }
  }
  return input;
}
}

int main(int argc, char** argv)
{
  const double seconds = argc > 1 ? std::atof(argv[1]) : 1.0;
  Random random(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1u);
  std::vector<Input> files;
  for (int i = 3; i < argc; ++i)
  {
    std::ifstream file(argv[i], std::ios::binary);
    files.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  for (std::size_t i = 0; i < files.size() && seconds <= 0.0; ++i)
  {
    LLVMFuzzerTestOneInput(files[i].data(), files[i].size());
  }
  const auto start = std::chrono::steady_clock::now();
  long inputs = 0;
  while (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < seconds)
  {
    const Input input = files.empty() ? randomBytes(random) : changed(files[below(random, files.size())], random);
    // What breaks off can be run again: the last input is in the file that this variable names.
    if (const char* path = std::getenv("STRATA_FUZZ_LAST"))
    {
      std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(input.data()), static_cast<std::streamsize>(input.size()));
    }
    LLVMFuzzerTestOneInput(input.data(), input.size());
    ++inputs;
  }
  std::printf("%ld inputs\n", inputs);
  return 0;
}
