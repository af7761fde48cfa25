#include "core/land/land_bytes.h"

// The assembler embeds the files, because a compiler would take seconds and a gigabyte for an array
// of that size. `BERG_LAND_FOLDER` is the folder of the files.
#ifndef BERG_LAND_FOLDER
#define BERG_LAND_FOLDER "." // for tools that read the source without compiling it
#endif
// NOLINTBEGIN(hicpp-no-assembler)
#define BERG_EMBED(symbol, file)                                                                   \
    asm(".section .rodata\n"                                                                       \
        ".global " #symbol "\n" #symbol ":\n"                                                      \
        ".incbin \"" BERG_LAND_FOLDER "/" file "\"\n"                                              \
        ".global " #symbol "_end\n" #symbol "_end:\n"                                              \
        ".byte 0\n"                                                                                \
        ".text\n")
BERG_EMBED(berg_land_10m, "land-10m.bin");
BERG_EMBED(berg_land_50m, "land-50m.bin");
// NOLINTEND(hicpp-no-assembler)

// NOLINTBEGIN(readability-identifier-naming,bugprone-reserved-identifier)
extern "C" {
extern const std::uint8_t berg_land_10m[];
extern const std::uint8_t berg_land_10m_end[];
extern const std::uint8_t berg_land_50m[];
extern const std::uint8_t berg_land_50m_end[];
}
// NOLINTEND(readability-identifier-naming,bugprone-reserved-identifier)

namespace berg {

std::span<const std::uint8_t> landBytes(LandDetail detail)
{
    return detail == LandDetail::Fine ? std::span(berg_land_10m, berg_land_10m_end)
                                      : std::span(berg_land_50m, berg_land_50m_end);
}

} // namespace berg
