#include "widgets/words/report_language.h"

#include <QCoreApplication>

namespace berg {

ReportWords reportLanguage()
{
    return ReportWords([](std::string_view english) {
        std::string text(english);
        for (const char* const context : {"Report", "EventText"})
            if (const QString said = QCoreApplication::translate(context, text.c_str());
                said != QString::fromUtf8(text))
                return said.toStdString();
        return text;
    });
}

} // namespace berg
