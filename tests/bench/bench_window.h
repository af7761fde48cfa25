#pragma once

#include "app/interaction.h"
#include "core/study/statistics.h"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace berg {

/** Nobody is there to answer. */
class NoDialogs final : public Interaction
{
public:
    Unsaved askUnsaved(QWidget*, const QString&) override { return Unsaved::Discard; }
    QString openPath(QWidget*, const QString&) override { return {}; }
    QString savePath(QWidget*, const QString&, const QString&) override { return {}; }
    std::optional<ExportChoice> chooseExport(QWidget*, const ExportOffer&) override { return {}; }
    void showError(QWidget*, const QString&) override {}
    void showInformation(QWidget*, const QString&, const QString&) override {}
};

inline void print(const char* name, std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    if (values.empty())
        std::printf("    %-16s none\n", name);
    else
        std::printf("    %-16s median %6.1f   p95 %6.1f   worst %6.1f ms   (%zu)\n", name,
                    quantile(values, 0.5), quantile(values, 0.95), values.back(), values.size());
}

} // namespace berg
