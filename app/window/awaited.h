#pragma once

#include "app/dialogs/interaction.h"
#include "core/base/stopped.h"

#include <chrono>
#include <future>

namespace berg {

/**
 * Does the job on another thread while the window takes no input but "Cancel", which the job is
 * told: `job(stop)`. False: it stopped for that. Throws what it throws. GUI thread.
 */
template <class Job>
bool awaited(Interaction& interaction, QWidget* parent, const QString& text, const Job& job)
{
    std::stop_source stop;
    std::future<void> work = std::async(std::launch::async, [&] { job(stop.get_token()); });
    interaction.waitUntil(parent, text, [&] {
        return work.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
    stop.request_stop();
    try {
        work.get();
    } catch (const Stopped&) {
        return false;
    }
    return true;
}

} // namespace berg
