#pragma once

#include <cstddef>
#include <new>
#include <vector>
#if defined(__unix__)
#include <sys/mman.h>
#endif

namespace berg {

/**
 * Allocator that takes large blocks of memory from the system and returns them at once. `malloc`
 * would keep blocks of up to 32 MB, and freeing something small later could then take as long as
 * releasing all of them.
 */
template <class T>
struct LargeAllocator
{
    using value_type = T;

    LargeAllocator() = default;
    template <class U>
    explicit LargeAllocator(const LargeAllocator<U>&)
    {
    }

    [[nodiscard]] T* allocate(std::size_t count)
    {
#if defined(__unix__)
        if (isLarge(count)) {
            void* const memory = mmap(nullptr, count * sizeof(T), PROT_READ | PROT_WRITE,
                                      MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
            if (memory == MAP_FAILED)
                throw std::bad_alloc();
            return static_cast<T*>(memory);
        }
#endif
        return static_cast<T*>(::operator new(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t count)
    {
#if defined(__unix__)
        if (isLarge(count)) {
            munmap(memory, count * sizeof(T));
            return;
        }
#endif
        ::operator delete(memory);
    }
    bool operator==(const LargeAllocator&) const
    {
        return true;
    }

private:
    [[nodiscard]] static bool isLarge(std::size_t count)
    {
        return count >= (std::size_t{1} << 20) / sizeof(T);
    }
};

/** Vector that returns large blocks of memory to the system at once. */
template <class T>
using LargeVector = std::vector<T, LargeAllocator<T>>;

} // namespace berg
