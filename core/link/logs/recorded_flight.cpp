#include "core/link/logs/recorded_flight.h"

#include "core/link/aircraft_state.h"

namespace berg {

bool FlightRecorder::add(const LoggedFrame& logged)
{
    constexpr std::size_t kMostFlights = 32;
    const std::optional<LinkMessage>& message = logged.frame.message;
    if (!message || message->id() != MessageId::GlobalPositionInt)
        return false;
    AircraftState state;
    updateState(state, *message, 0);
    const LinkAddress sender = logged.frame.sender;
    if (!state.position || (!m_flights.contains(sender) && m_flights.size() >= kMostFlights))
        return false;
    m_flights[sender].push_back({.unix_us = logged.unix_us,
                                 .place = state.position->place,
                                 .altitude_m = state.position->altitude_m});
    return true;
}

} // namespace berg
