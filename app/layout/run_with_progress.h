#pragma once

#include "app/dialogs/interaction.h"
#include "core/base/stopped.h"

#include <QScopedValueRollback>

#include <chrono>
#include <future>
#include <type_traits>

namespace berg {

/**
 * Runs the job on another thread while the window takes no input. If the job accepts a stop token
 * (`job(stop)`), the user can cancel it, and the function then returns false. Rethrows exceptions
 * of the job. GUI thread.
 */
template <class Job>
bool runWithProgress(Interaction& interaction, QWidget* parent, const QString& text, const Job& job)
{
    constexpr bool kMayCancel = std::is_invocable_v<Job, const std::stop_token&>;
    std::stop_source stop;
    std::future<void> work = std::async(std::launch::async, [&] {
        if constexpr (kMayCancel)
            job(stop.get_token());
        else
            job();
    });
    const auto isDone = [&] {
        return work.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    };
    const QScopedValueRollback awaits(interaction.isAwaited, true);
    interaction.waitUntil(parent, text, isDone, kMayCancel);
    stop.request_stop();
    try {
        work.get();
    } catch (const Stopped&) {
        return false;
    }
    return true;
}

} // namespace berg
