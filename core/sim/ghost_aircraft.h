#pragma once

#include "core/link/link_session.h"
#include "core/sim/rehearsal_vehicle.h"

#include <memory>
#include <optional>
#include <vector>

namespace berg {

/** Last known state of an aircraft when contact is lost. */
struct LastContact
{
    LinkVehicle vehicle; ///< its position must be known
    /** Mission as it was read back, without home; empty if it is unknown. */
    std::vector<LinkMissionItem> onBoard;
    UavSpec uav;
    Point wind_mps = Point::Zero(); ///< wind over ground, east and north
};

/** The place where an aircraft should be heard again. */
struct ExpectedContact
{
    LatLon place;
    double at_s = 0; ///< clock of the last contact's times
};

/**
 * The aircraft where it should be now: it flies on from the last contact along the mission on
 * board, or in the mode in which it was. If it flies a mission that is unknown, it flies straight
 * on. Used by one thread.
 */
class GhostAircraft
{
public:
    /** Throws `std::logic_error` if the position is unknown. */
    explicit GhostAircraft(const LastContact& last);

    /** Flies up to `now_s`, by the clock of the last contact's times. */
    void advance(double now_s);
    [[nodiscard]] const VehicleReadings& readings() const { return m_flight.readings(); }

    /**
     * Returns where and when the aircraft comes within `range_m` of `station` again, at most
     * `horizon_s` after the present instant; nullopt if it does not. In range it is here and now.
     */
    [[nodiscard]] std::optional<ExpectedContact>
    expectedContact(const LatLon& station, double range_m, double horizon_s) const;

private:
    /** Receives and sends nothing. */
    class NoLink final : public ByteLink
    {
    public:
        [[nodiscard]] bool isDatagram() const override { return true; }
        [[nodiscard]] std::vector<int> peers() const override { return {}; }
        [[nodiscard]] std::optional<LinkPacket> receive() override { return std::nullopt; }
        void send(int, std::span<const std::uint8_t>) override {}
    };

    std::shared_ptr<NoLink> m_link = std::make_shared<NoLink>(); ///< used by every copy
    RehearsalVehicle m_flight;
    double m_now_s;
};

} // namespace berg
