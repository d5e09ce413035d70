// NumPy arrays: what is read has as many values as its shape, and no difference from itself.
#include "core/io/npy.h"
#include "core/truth/array_difference.h"
#include "tests/fuzz/target.h"

using namespace rasterlens;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const NpyRead read = readNpy(fuzz::bytesOf(data, size));
    fuzz::require(read.array.has_value() == read.error.isEmpty(), "there is either an array or an error");
    if (!read.array)
        return 0;
    std::size_t count = 1;
    for (const qint64 length : read.array->shape)
        count *= static_cast<std::size_t>(length);
    fuzz::require(count == read.array->size(), "an array has as many values as its shape");
    const ArrayDifference itself = difference(*read.array, *read.array);
    fuzz::require(itself.values == count && itself.differing == 0 && itself.max == 0, "an array equals itself");
    return 0;
}
