#pragma once

#include <cstddef>
#include <new>
#include <vector>
#if defined(__unix__)
#include <sys/mman.h>
#endif

namespace berg {

/**
 * Gets large pieces of memory from the system and gives them back at once. `malloc` keeps what has
 * up to 32 MB for later, and whoever frees something small in the end waits for all of it to go.
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

template <class T>
using LargeVector = std::vector<T, LargeAllocator<T>>;

} // namespace berg
