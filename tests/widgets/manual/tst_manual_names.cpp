#include "widgets/manual/manual.h"
#include "widgets/theme/language.h"
#include "widgets/words/policy_words.h"

#include <QRegularExpression>
#include <QScopeGuard>
#include <QtTest>

#include <algorithm>

using namespace berg;
using namespace Qt::StringLiterals;

/** The manual uses the names of the window. */
class TestManualNames : public QObject
{
    Q_OBJECT

private slots:
    void policyNamesAreInTheManual_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << u"en"_s;
        QTest::newRow("Norwegian") << u"nb"_s;
    }

    void policyNamesAreInTheManual()
    {
        QFETCH(QString, language);
        installLanguage(language);
        const auto back = qScopeGuard([] { installLanguage(u"en"_s); });
        const Manual manual = readManual(language);
        const std::vector<MarkdownBlock>& blocks = manual.chapterAt(u"policies"_s)->blocks;
        const auto table = std::ranges::find_if(
            blocks, [](const MarkdownBlock& block) { return !block.rows.empty(); });
        QVERIFY(table != blocks.end());
        QCOMPARE(table->rows.size(), kOfferedPolicies.size() + 1);
        for (const PolicyKind policy : kOfferedPolicies) {
            const QString key = QString::fromStdString(std::string(nameOf(kPolicyNames, policy)));
            const auto row = std::ranges::find_if(
                table->rows, [&](const QStringList& cells) { return cells.front() == key; });
            QVERIFY2(row != table->rows.end(), qPrintable(key));
            QCOMPARE(row->at(1), policyName(policy));
            if (policy != PolicyKind::Visitation) // its τ is any
                QCOMPARE(row->at(2), shortPolicyText({.policy = policy}, QLocale(language)));
        }
    }

    /** Sentences use the names of the window; those of the command line are in its commands. */
    void sentencesUseNamesOfTheWindow()
    {
        static const QRegularExpression kKey(
            u"`(visitation|latency|coverage|path|tour|nearest|uncertainty)`"_s);
        for (const QString& language : {u"en"_s, u"nb"_s})
            for (const ManualChapter& chapter : readManual(language).chapters)
                for (const MarkdownBlock& block : chapter.blocks)
                    if (chapter.name != u"fields"_s && chapter.name != u"commands"_s)
                        QVERIFY2(!kKey.match(block.text).hasMatch(), qPrintable(block.text));
    }
};

QTEST_MAIN(TestManualNames)
#include "tst_manual_names.moc"
