#pragma once

#include "core/link/message/message_table.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** Ids of the messages that the code names; the table contains more. */
enum class MessageId : std::uint32_t
{
    Heartbeat = 0,
    SysStatus = 1,
    SystemTime = 2,
    Ping = 4,
    SetMode = 11,
    ParamRequestRead = 20,
    ParamRequestList = 21,
    ParamValue = 22,
    ParamSet = 23,
    GpsRawInt = 24,
    Attitude = 30,
    GlobalPositionInt = 33,
    MissionWritePartialList = 38,
    MissionItem = 39,
    MissionRequest = 40,
    MissionSetCurrent = 41,
    MissionCurrent = 42,
    MissionRequestList = 43,
    MissionCount = 44,
    MissionClearAll = 45,
    MissionItemReached = 46,
    MissionAck = 47,
    MissionRequestInt = 51,
    RequestDataStream = 66,
    MissionItemInt = 73,
    VfrHud = 74,
    CommandInt = 75,
    CommandLong = 76,
    CommandAck = 77,
    BatteryStatus = 147,
    AutopilotVersion = 148,
    RadioStatus = 109,
    Timesync = 111,
    Wind = 168,
    WindCov = 231,
    HomePosition = 242,
    ExtendedSysState = 245,
    AdsbVehicle = 246,
    StatusText = 253,
    AisVessel = 301
};

/**
 * One message: an id and its payload at full length. Fields have the names of MAVLink's XML files
 * and the units of the protocol. An unknown field name, a field of another type than the function
 * expects or an index outside the array is a bug of the caller and throws `std::logic_error`.
 */
class LinkMessage
{
public:
    /** Creates a message of zeros. Throws `std::logic_error` if the id is not in the table. */
    explicit LinkMessage(MessageId id);
    /**
     * Creates a message from a received payload: missing bytes become zeros, excess bytes are
     * dropped.
     */
    LinkMessage(const MessageSpec& spec, std::span<const std::uint8_t> payload);

    [[nodiscard]] MessageId id() const { return static_cast<MessageId>(m_spec->id); }
    [[nodiscard]] const MessageSpec& spec() const { return *m_spec; }
    [[nodiscard]] std::span<const std::uint8_t> payload() const { return m_payload; }

    /** Returns true if the message has a field of this name. */
    [[nodiscard]] bool has(std::string_view field) const;
    /**
     * Returns an element of an integer field; a u64 above 2^63 is returned as its two's complement.
     */
    [[nodiscard]] std::int64_t integer(std::string_view field, int index = 0) const;
    /** Returns an element of any field as a number; a float may be NaN or infinite. */
    [[nodiscard]] double real(std::string_view field, int index = 0) const;
    /**
     * Returns a char array up to its first NUL. The sender chose the bytes, so any encoding is
     * possible.
     */
    [[nodiscard]] std::string text(std::string_view field) const;

    /** Sets an element of an integer field to the nearest value that fits; a u64 takes the bits. */
    LinkMessage& with(std::string_view field, std::int64_t value, int index = 0);
    /** Sets an element of a float field. */
    LinkMessage& withReal(std::string_view field, double value, int index = 0);
    /** Sets a char array; longer text is cut, and the rest of the array becomes NUL. */
    LinkMessage& withText(std::string_view field, std::string_view text);

    bool operator==(const LinkMessage& other) const
    {
        return m_spec == other.m_spec && m_payload == other.m_payload;
    }

private:
    [[nodiscard]] const MessageField& fieldNamed(std::string_view name) const;
    /** Returns the offset of an element in the payload. */
    [[nodiscard]] std::size_t placeOf(const MessageField& field, int index) const;

    const MessageSpec* m_spec; ///< Points into the table, which is never destroyed.
    std::vector<std::uint8_t> m_payload;
};

} // namespace berg
