#include "widgets/panels/study/study_setup.h"

#include "core/plan/policy/policy.h"
#include "widgets/charts/study_chart.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/words/policy_words.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QRadioButton>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kGap_px = 6;
constexpr int kSection_px = 10;
constexpr int kMark_px = 12;
constexpr double kMostTaus = 1000;
constexpr double kRandom = 100;
constexpr double kIcebergs = 12; ///< Table 3 of the paper
constexpr double kMostScenarios = 100'000;
constexpr double kMostRuns = 10'000;
constexpr double kLastSeed = 999'999'999;

QIcon markIcon(PolicyKind policy, const Theme& theme)
{
    const QPixmap pixmap = policyPixmap(policy, theme, kMark_px);
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Disabled);
    return icon;
}

QVBoxLayout& columnOf(QWidget& widget)
{
    return *qobject_cast<QVBoxLayout*>(widget.layout());
}

} // namespace

std::vector<double> tausBetween(double low, double high, double step)
{
    constexpr double kDigits = 1e9; // more than can be typed
    std::vector<double> taus;
    const double count = step > 0 ? std::floor((high - low) / step + 1e-9) : 0;
    for (double k = 0; k <= std::min(count, kMostTaus); ++k)
        taus.push_back(std::round((low + k * step) * kDigits) / kDigits);
    return taus;
}

StudySetup::StudySetup(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGap_px);
    addScenarios();
    column->addSpacing(kSection_px);
    addPolicies();
    updateEnabled();
}

NumberField* StudySetup::addNumber(QBoxLayout& row, const NumberSpec& spec)
{
    auto* field = new NumberField;
    field->setObjectName(QLatin1String(spec.name));
    field->setAccessibleName(spec.label);
    field->setToolTip(spec.toolTip);
    field->setRange(spec.low, spec.high);
    field->setNumberFormat({.least = 0, .most = spec.decimals}, {});
    field->setSingleStep(std::pow(10, -std::min(1, spec.decimals)));
    field->showValue(spec.value);
    auto* caption = new CaptionLabel(spec.label);
    caption->setWordWrap(false);
    caption->setBuddy(field);
    auto* pair = new QVBoxLayout;
    pair->setSpacing(1);
    pair->addWidget(caption);
    pair->addWidget(withRemark(field));
    row.addLayout(pair, 1);
    connect(field, &NumberField::edited, this, [this, field] {
        if (field == m_from || field == m_to || field == m_step)
            m_listed.clear();
        updateEnabled();
        emit edited();
    });
    return field;
}

void StudySetup::addScenarios()
{
    QVBoxLayout& column = columnOf(*this);
    m_this = new QRadioButton(tr("This scenario"));
    m_this->setObjectName(u"studyThis"_s);
    m_this->setChecked(true);
    m_random = new QRadioButton(tr("Random scenarios"));
    m_random->setObjectName(u"studyRandom"_s);
    m_random->setToolTip(tr("Fields of icebergs as in Table 3 of the paper, one for each seed."));
    for (QRadioButton* button : {m_this, m_random})
        column.addWidget(button);
    connect(m_random, &QRadioButton::toggled, this, [this] {
        updateEnabled();
        emit edited();
    });
    auto* row = new QHBoxLayout;
    row->setSpacing(kGap_px);
    m_count = addNumber(*row, {"studyCount", tr("Number"), 1, kMostScenarios, kRandom, 0,
                               tr("Number of random scenarios.")});
    m_seed = addNumber(*row, {"studySeed", tr("First seed"), 0, kLastSeed, 1, 0,
                              tr("Further scenarios use the seeds that follow.")});
    m_icebergs = addNumber(*row, {"studyIcebergs", tr("Icebergs"), 1, 500, kIcebergs, 0,
                                  tr("Number of icebergs in each random scenario.")});
    column.addLayout(row);
    auto* runs = new QHBoxLayout;
    runs->setSpacing(kGap_px);
    runs->addLayout(addRegime(), 2);
    m_runs = addNumber(*runs, {"studyRuns", tr("Runs each"), 1, kMostRuns, 1, 0,
                               tr("Flights of each scenario with different noise: the true drift "
                                  "is drawn again, identically for every setting.")});
    column.addLayout(runs);
}

QLayout* StudySetup::addRegime()
{
    m_regime = new QComboBox;
    m_regime->setObjectName(u"studyRegime"_s);
    m_regime->setToolTip(
        tr("Knowledge of the drift in random scenarios, and how icebergs are observed."));
    const auto add = [this](FieldRegime regime, const QString& name, const QString& toolTip) {
        m_regime->addItem(name, static_cast<int>(regime));
        m_regime->setItemData(m_regime->count() - 1, toolTip, Qt::ToolTipRole);
    };
    add(FieldRegime::Published, tr("As published"),
        tr("Velocities are known, and an iceberg in view has no uncertainty."));
    add(FieldRegime::Measured, tr("Measured"),
        tr("Measurements with noise, filtered for position and velocity."));
    add(FieldRegime::UnknownVelocity, tr("Unknown velocity"),
        tr("Measured; velocities are uncertain by 0.1 m/s along each axis."));
    add(FieldRegime::FittedDrift, tr("Real drift"),
        tr("Measured; velocities are unknown and change, as observed for icebergs with beacons."));
    connect(m_regime, &QComboBox::currentIndexChanged, this, &StudySetup::edited);
    auto* caption = new CaptionLabel(tr("Drift"));
    caption->setBuddy(m_regime);
    m_regime->setAccessibleName(caption->text());
    auto* pair = new QVBoxLayout;
    pair->setSpacing(1);
    pair->addWidget(caption);
    pair->addWidget(m_regime);
    return pair;
}

void StudySetup::addTau()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(kGap_px);
    m_from = addNumber(*row, {"studyTauFrom", tr("τ from"), 0, limits::kTau.high, 0, 3,
                              tr("Smallest trade-off τ.")});
    m_to = addNumber(*row, {"studyTauTo", tr("to", "largest tau"), 0, limits::kTau.high, 4, 3,
                            tr("Largest trade-off τ.")});
    m_step = addNumber(*row, {"studyTauStep", tr("step", "of tau"), 0.001, limits::kTau.high, 0.1,
                              3, tr("Step between two values of τ.")});
    columnOf(*this).addLayout(row);
}

void StudySetup::addPolicies()
{
    for (const PolicyKind policy : kOfferedPolicies) {
        // Without the remark in brackets, for which only the tool tip has room.
        auto* box = new QCheckBox(policyName(policy).section(u" ("_s, 0, 0));
        box->setObjectName(u"studyPolicy-"_s +
                           QString::fromStdString(nameOf(kPolicyNames, policy)));
        box->setToolTip(policyName(policy) + u'\n' + policySentence(policy));
        box->setChecked(policy == PolicyKind::Visitation || policy == PolicyKind::Path);
        connect(box, &QCheckBox::toggled, this, [this] {
            updateEnabled();
            emit edited();
        });
        columnOf(*this).addWidget(box);
        m_policies.emplace_back(policy, box);
        if (traitsOf(policy).usesTau)
            addTau(); // the fields of this policy's tau
    }
}

void StudySetup::setTheme(const Theme& theme)
{
    setCaptionTheme(*this, theme);
    for (const auto& [policy, box] : m_policies) {
        box->setIcon(markIcon(policy, theme));
        box->setIconSize({kMark_px, kMark_px});
    }
}

void StudySetup::setScenario(const Scenario& scenario)
{
    m_scenario = scenario;
    m_this->setToolTip(QString::fromStdString(scenario.name));
    emit edited();
}

std::vector<double> StudySetup::taus() const
{
    if (!m_policies.front().second->isChecked())
        return {};
    return m_listed.empty() ? tausBetween(m_from->value(), m_to->value(), m_step->value())
                            : m_listed;
}

StudySpec StudySetup::spec() const
{
    StudySpec spec{.taus = taus(), .runs = static_cast<int>(m_runs->value())};
    if (m_this->isChecked()) {
        spec.name = m_scenario.name;
        spec.scenarios = {m_scenario};
    } else {
        spec.random = static_cast<int>(m_count->value());
        spec.firstSeed = static_cast<std::int64_t>(m_seed->value());
        spec.field.icebergs = static_cast<int>(m_icebergs->value());
        spec.field.regime = static_cast<FieldRegime>(m_regime->currentData().toInt());
        spec.name = tr("%n random scenarios", nullptr, spec.random).toStdString();
    }
    for (const auto& [policy, box] : m_policies)
        if (box->isChecked())
            spec.policies.push_back(policy);
    return spec;
}

void StudySetup::showSpec(const StudySpec& spec)
{
    (spec.random > 0 ? m_random : m_this)->setChecked(true);
    if (spec.random > 0) {
        m_count->showValue(spec.random);
        m_seed->showValue(static_cast<double>(spec.firstSeed));
        m_icebergs->showValue(spec.field.icebergs);
        m_regime->setCurrentIndex(m_regime->findData(static_cast<int>(spec.field.regime)));
    }
    m_runs->showValue(spec.runs);
    if (!spec.taus.empty()) {
        m_from->showValue(spec.taus.front());
        m_to->showValue(spec.taus.back());
        if (spec.taus.size() > 1)
            m_step->showValue(spec.taus[1] - spec.taus[0]);
    }
    const bool isEven = tausBetween(m_from->value(), m_to->value(), m_step->value()) == spec.taus;
    m_listed = isEven ? std::vector<double>() : spec.taus;
    for (const auto& [policy, box] : m_policies)
        box->setChecked(std::find(spec.policies.begin(), spec.policies.end(), policy) !=
                        spec.policies.end());
    updateEnabled();
    emit edited();
}

QString StudySetup::fault() const
{
    const StudySpec wanted = spec();
    if (m_this->isChecked() && m_scenario.icebergs.empty())
        return tr("This scenario has no icebergs.");
    if (m_policies.front().second->isChecked() && m_listed.empty() &&
        m_to->value() < m_from->value())
        return tr("The largest τ is below the smallest.");
    if (wanted.taus.size() > static_cast<std::size_t>(kMostTaus))
        return tr("Too many values of τ. Choose a larger step.");
    if (settingsOf(wanted).empty())
        return tr("Choose at least one policy.");
    const double missions = static_cast<double>(settingsOf(wanted).size()) * wanted.runs *
                            (m_this->isChecked() ? 1 : wanted.random);
    if (missions > static_cast<double>(kMostMissions))
        return tr("A study has at most %1 missions.")
            .arg(locale().toString(static_cast<qulonglong>(kMostMissions)));
    return {};
}

void StudySetup::finishTyping()
{
    for (NumberField* field : findChildren<NumberField*>())
        field->finishTyping();
}

void StudySetup::updateEnabled()
{
    for (NumberField* field : {m_count, m_seed, m_icebergs})
        field->setEnabled(m_random->isChecked());
    m_regime->setEnabled(m_random->isChecked());
    for (NumberField* field : {m_from, m_to, m_step})
        field->setEnabled(m_policies.front().second->isChecked());
}

} // namespace berg
