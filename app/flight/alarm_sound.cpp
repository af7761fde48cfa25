#include "app/flight/alarm_sound.h"

#include "app/dialogs/interaction.h"
#include "app/layout/panels.h"
#include "widgets/panels/flight/alarm_strip.h"

#include <QMainWindow>
#include <QSettings>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr const char* kSoundKey = "alarms/sound";
constexpr int kAgain_ms = 5000;

} // namespace

AlarmSound::AlarmSound(WindowContext& context)
    : WindowPart(context), m_again(&window()), m_isOn(settings().value(kSoundKey, true).toBool())
{
    m_again.setObjectName(u"alarmSoundTimer"_s);
    m_again.setInterval(kAgain_ms);
    connect(&m_again, &QTimer::timeout, this, &AlarmSound::sound);
    connect(panels().alarms, &AlarmStrip::raised, this, [this] {
        if (m_isOn)
            sound();
    });
    connect(panels().alarms, &AlarmStrip::alarmPending, this, &AlarmSound::setPending);
}

void AlarmSound::setOn(bool isOn)
{
    m_isOn = isOn;
    settings().setValue(kSoundKey, isOn);
    setPending(m_isPending);
}

void AlarmSound::setPending(bool isPending)
{
    m_isPending = isPending;
    if (!isPending || !m_isOn)
        m_again.stop();
    else if (!m_again.isActive())
        m_again.start();
}

void AlarmSound::sound() const
{
    interaction().soundAlarm();
}

} // namespace berg
