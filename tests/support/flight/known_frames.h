#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace berg::test {

/** A frame written by another implementation. */
struct KnownFrame
{
    std::string_view name;
    std::string_view hex;
};

/**
 * Frames written by MAVLink's C library and confirmed with pymavlink and node-mavlink. Ground
 * station 255/190, vehicle 1/1; the last one is signed with the key 00, 01, .. 1F.
 */
inline constexpr KnownFrame kKnownFrames[] = {
    {"HEARTBEAT_gcs", "fd09000000ffbe0000000000000006080004033d48"},
    {"HEARTBEAT_plane", "fd0900000701010000000a00000001039d0403533d"},
    {"MISSION_COUNT", "fd04000001ffbe2c00000e000101e265"},
    {"MISSION_REQUEST_INT_0", "fd0400000801013300000000ffbea1f9"},
    {"MISSION_REQUEST_3", "fd0400000901012800000300ffbef84f"},
    {"MISSION_ITEM_INT",
     "fd25000002ffbe490000000000000000c841000000000000c07f8870041cc01f65e30000f04201001000"
     "0101030001b6b9"},
    {"MISSION_ACK_ok", "fd0200000a01012f0000ffbeecb0"},
    {"MISSION_ACK_nospace_fence", "fd0400000b01012f0000ffbe0401d8c8"},
    {"MISSION_REQUEST_LIST", "fd02000003ffbe2b00000101af46"},
    {"MISSION_CLEAR_ALL_all", "fd03000004ffbe2d00000101ff04bb"},
    {"MISSION_CURRENT", "fd0a00000c01012a000002000e000301785634129c44"},
    {"MISSION_ITEM_REACHED", "fd0100000d01012e000002d308"},
    {"GLOBAL_POSITION_INT",
     "fd1c00000e010121000040e201008870041cc01f65e39cda0100c0d4010024fa4006ecffb87a96f0"},
    {"ATTITUDE",
     "fd1c00000f01011e000040e20100cdcccc3dcdcc4cbddb0fc93f0000000000000000cdcc4c3ed601"},
    {"VFR_HUD", "fd1300001001014a00000000b4410000c2410000f342000080be5a0037d46a"},
    {"BATTERY_STATUS",
     "fd2900001101019300001c0c0000ffffffffff7f04100310021001100010ff0fffffffffffffffffe204"
     "00000148100e000001d128"},
    {"WIND", "fd080000120101a800000000874300000841da2b"},
    {"WIND_COV",
     "fd200000130101e7000040420f000000000000004040000080c0000000000000003f0000003f0000f342"
     "ec91"},
    {"COMMAND_INT_DO_REPOSITION",
     "fd21000005ffbe4b0000000080bf0000803f00009643000000008870041cc01f65e30000f042c0000101"
     "03fc24"},
    {"COMMAND_LONG_SET_MESSAGE_INTERVAL",
     "fd20000006ffbe4c0000000004420024f4480000000000000000000000000000000000000000ff010101"
     "baec"},
    {"COMMAND_ACK_ok", "fd0a00001401014d0000c000000000000000ffbed08b"},
    {"SET_POSITION_TARGET_GLOBAL_INT",
     "fd35000015ffbe560000e80300008870041cc01f65e30000f04200000000000000000000000000000000"
     "00000000000000000000000000000000f80f0101068314"},
    {"STATUSTEXT",
     "fd1d0000160101fd0000065265616368656420776179706f696e7420233220646973742032346d73b7"},
    {"MISSION_COUNT_zero", "fd0100001701012c000000fbe3"},
    {"SIGNED_MISSION_ITEM_REACHED", "fd0101001801012e000002ede80515cd5b070000374cf2ee4fa5"},
};

/** Returns the bytes of a text of hexadecimal digits. */
inline std::vector<std::uint8_t> bytesOfHex(std::string_view hex)
{
    const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes.push_back(static_cast<std::uint8_t>(16 * digit(hex[i]) + digit(hex[i + 1])));
    return bytes;
}

/** Returns the bytes of a frame above; empty if there is none of this name. */
inline std::vector<std::uint8_t> knownFrame(std::string_view name)
{
    for (const KnownFrame& frame : kKnownFrames)
        if (frame.name == name)
            return bytesOfHex(frame.hex);
    return {};
}

} // namespace berg::test
