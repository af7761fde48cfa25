#include "widgets/panels/aircraft/log_rows.h"

#include "widgets/theme/quantity_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kParts = 1000;

} // namespace

LogRows::LogRows(QWidget* parent)
    : QWidget(parent)
    , m_write(new QCheckBox(tr("Write a log")))
    , m_open(new QPushButton(tr("Open a log…")))
    , m_file(new QLabel)
    , m_progress(new QProgressBar)
    , m_speed(new QComboBox)
    , m_theme(Theme::light())
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_write->setObjectName(u"logSwitch"_s);
    m_open->setObjectName(u"openLogButton"_s);
    m_open->setToolTip(tr("Plays a recorded flight (.tlog) in place of a link."));
    m_open->setAutoDefault(false);
    m_file->setObjectName(u"logState"_s);
    m_file->setTextFormat(Qt::PlainText);
    m_file->setWordWrap(true);
    m_file->hide();
    m_progress->setObjectName(u"replayProgress"_s);
    m_progress->setAccessibleName(tr("Part of the log that has been played"));
    m_progress->setRange(0, kParts);
    m_speed->setObjectName(u"replaySpeed"_s);
    m_speed->setAccessibleName(tr("Speed of the replay"));
    for (const int speed : {1, 2, 5, 10, 30, 60, 300})
        m_speed->addItem(u"%1×"_s.arg(speed), speed);
    m_speed->setToolTip(tr("Seconds of the log that are played in each second"));
    auto* choices = new QHBoxLayout;
    choices->addWidget(m_write);
    choices->addStretch();
    choices->addWidget(m_open);
    auto* replay = new QHBoxLayout;
    replay->addWidget(m_progress, 1);
    replay->addWidget(m_speed);
    column->addLayout(choices);
    column->addWidget(m_file);
    column->addLayout(replay);
    m_progress->hide();
    m_speed->hide();
    connect(m_write, &QCheckBox::clicked, this, &LogRows::logEdited);
    connect(m_open, &QPushButton::clicked, this, &LogRows::openRequested);
    connect(m_speed, &QComboBox::activated, this, [this] { emit speedEdited(speed()); });
}

void LogRows::setChoice(bool isOn, const QString& folder)
{
    m_write->setChecked(isOn);
    m_write->setToolTip(
        tr("Writes every frame sent and received to a new file (.tlog) in the folder %1.")
            .arg(folder));
}

double LogRows::speed() const
{
    return m_speed->currentData().toDouble();
}

void LogRows::showStatus(const LinkStatus& status)
{
    const LogReport& log = status.log;
    const QString path = QString::fromStdString(log.path);
    QString text;
    bool isFault = false;
    if (status.replay) {
        const ReplayReport& replay = *status.replay;
        const QString name = QFileInfo(QString::fromStdString(replay.path)).fileName();
        const QString at = clockText(replay.played_s);
        text = replay.isAtEnd ? tr("Log %1 has been played: %2").arg(name, at)
                              : tr("Playing log %1: %2").arg(name, at);
        if (replay.skipped_bytes > 0)
            text += u'\n' +
                    tr("Damaged parts were skipped (%1).")
                        .arg(locale().formattedDataSize(static_cast<qint64>(replay.skipped_bytes)));
        m_progress->setValue(qRound(kParts * replay.part));
    } else if (isFault = !log.fault.empty(); isFault) {
        text =
            tr("The log cannot be written: %1 (%2)").arg(QString::fromStdString(log.fault), path);
    } else if (isFault = log.isFull; isFault) {
        text = tr("The log has reached its largest size and has ended: %1").arg(path);
    } else if (!path.isEmpty()) {
        text = tr("Log: %1 (%2)")
                   .arg(path, locale().formattedDataSize(static_cast<qint64>(log.bytes)));
    }
    QPalette colours = palette();
    if (isFault)
        colours.setColor(QPalette::WindowText, m_theme.warning);
    m_file->setPalette(colours);
    m_file->setText(text);
    m_file->setVisible(!text.isEmpty());
    m_progress->setVisible(status.replay.has_value());
    m_speed->setVisible(status.replay.has_value());
}

} // namespace berg
