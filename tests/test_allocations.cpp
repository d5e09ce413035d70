// Every allocation of core fails once: what was asked for is then not there, nothing is lost but that, and the next
// attempt comes to the same as the first.
#include "core/derive/derive.h"
#include "core/io/npy.h"
#include "core/io/session.h"
#include "core/lessons/lesson.h"
#include "core/questions/why.h"
#include "core/render/render.h"
#include "core/render/steps.h"
#include "core/scenes/builtin_scenes.h"
#include "core/scenes/load_scene.h"
#include "core/truth/judgement.h"
#include "scene_files.h"

#include <QImage>
#include <QJsonDocument>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <new>
#include <system_error>
#include <vector>

#include <link.h>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr long kNever = -1;
thread_local long allocationsLeft = kNever; ///< of this thread, until one fails

/// Where the code of a Qt library lies in memory.
struct CodeRange {
    std::uintptr_t begin;
    std::uintptr_t end;
};

/// The Qt libraries of this program. They are not made for their own allocations to fail: one that does while they read
/// a picture leaves a lock of theirs locked for ever.
std::vector<CodeRange> codeOfQt()
{
    std::vector<CodeRange> ranges;
    const auto look = [](dl_phdr_info* library, std::size_t, void* data) {
        if (std::strstr(library->dlpi_name, "libQt6") == nullptr)
            return 0;
        for (int i = 0; i < library->dlpi_phnum; ++i)
            if (const auto& part = library->dlpi_phdr[i]; part.p_type == PT_LOAD && (part.p_flags & PF_X) != 0) {
                const std::uintptr_t begin = library->dlpi_addr + part.p_vaddr;
                static_cast<std::vector<CodeRange>*>(data)->push_back({begin, begin + part.p_memsz});
            }
        return 0;
    };
    dl_iterate_phdr(look, &ranges);
    return ranges;
}

const std::vector<CodeRange> qtCode = codeOfQt();

/// Counts an allocation of ours; false: it is the one that fails.
bool mayAllocate(const void* caller)
{
    if (allocationsLeft == kNever)
        return true;
    const auto address = reinterpret_cast<std::uintptr_t>(caller);
    for (const CodeRange& range : qtCode)
        if (range.begin <= address && address < range.end)
            return true;
    return allocationsLeft-- != 0; // behind the one that fails the count is kNever: there is memory again
}

void* allocate(std::size_t size, std::size_t alignment, const void* caller)
{
    void* memory = nullptr;
    if (!mayAllocate(caller) || posix_memalign(&memory, std::max(alignment, sizeof(void*)), size) != 0)
        return nullptr;
    return memory;
}

void* allocateOrThrow(std::size_t size, std::size_t alignment, const void* caller)
{
    if (void* memory = allocate(size, alignment, caller))
        return memory;
    throw std::bad_alloc();
}

constexpr std::size_t kUsual = alignof(std::max_align_t);

} // namespace

#define RASTERLENS_CALLER __builtin_return_address(0)

void* operator new(std::size_t size) { return allocateOrThrow(size, kUsual, RASTERLENS_CALLER); }
void* operator new[](std::size_t size) { return allocateOrThrow(size, kUsual, RASTERLENS_CALLER); }
void* operator new(std::size_t size, std::align_val_t a)
{
    return allocateOrThrow(size, std::size_t(a), RASTERLENS_CALLER);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    return allocate(size, kUsual, RASTERLENS_CALLER);
}
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

class TestAllocations : public QObject
{
    Q_OBJECT

    Folder m_files;
    std::map<QString, std::function<QByteArray()>> m_works;

    /// A picture and the arrays that come with it.
    static QByteArray drawn(const Scene& scene, const Settings& settings)
    {
        Frame frame;
        render(scene, settings, frame, {.depth = true, .ids = true});
        const QImage& image = frame.image;
        return QByteArray(reinterpret_cast<const char*>(image.constBits()), image.sizeInBytes()) +
               QByteArray(reinterpret_cast<const char*>(frame.depth.data()), qsizetype(frame.depth.size()) * 4);
    }

    static QByteArray textOfScene(const SceneLoad& load)
    {
        QByteArray text = textOf(load.diagnostics).toUtf8();
        if (load.scene)
            for (const MeshVertex& vertex : load.scene->mesh.vertices)
                text += QByteArray::number(double(vertex.position.x + 10 * vertex.position.y)) + ' ';
        return text;
    }

    static Settings small(Algorithm algorithm)
    {
        Settings settings = makeBuiltinScene("cube").scene->defaults;
        settings.size = {24, 20};
        settings.algorithm = algorithm;
        settings.threads = 1;
        return settings;
    }

    void describeWorks()
    {
        QImage image(2, 2, QImage::Format_ARGB32);
        image.fill(qRgba(10, 20, 30, 128));
        image.save(m_files.path(QStringLiteral("t.png")));
        m_files.write(QStringLiteral("m.mtl"),
                      "newmtl a\nKd 1 0 0\nmap_Kd t.png\nmap_d t.png\nnewmtl b\nmap_Kd no.png\n");
        const QString obj = m_files.write(QStringLiteral("m.obj"),
                                          "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 1\nvt 0 0\nvt 1 1\n"
                                          "usemtl a\nf 1/1 2/2 3/1 4/2\nusemtl b\nf 1 2 5\nf 1 2 x\n");
        const QString session =
            m_files.write(QStringLiteral("s.json"), R"({"rasterlens": 1, "scene": "m.obj", "settings": {"size": "9x9"},
                                                        "vertices": {"0": [1, 2, 3, 1]}})");
        m_works[QStringLiteral("OBJ")] = [obj] { return textOfScene(loadScene(obj)); };
        m_works[QStringLiteral("scene")] = [] { return textOfScene(makeBuiltinScene("cube")); };
        m_works[QStringLiteral("session")] = [session] {
            const SessionLoad load = loadSession(session);
            return load.session ? load.session->scene.toUtf8() : textOf(load.diagnostics).toUtf8();
        };
        m_works[QStringLiteral("lesson")] = [] {
            const LessonLoad load = loadLesson(QStringLiteral("top-left"));
            return load.lesson ? QByteArray::number(qulonglong(load.lesson->slides.size()))
                               : textOf(load.diagnostics).toUtf8();
        };
        const auto scene = std::make_shared<const Scene>(*makeBuiltinScene("cube").scene);
        for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking, Algorithm::Tiled})
            m_works[QStringLiteral("picture %1").arg(int(algorithm))] = [=] { return drawn(*scene, small(algorithm)); };
        const Settings usual = small(Algorithm::EdgeEquation);
        Settings samples = usual;
        samples.samples = Samples::Msaa4;
        m_works[QStringLiteral("samples")] = [=] { return drawn(*scene, samples); };
        m_works[QStringLiteral("record")] = [=] {
            const auto record = recordSteps(scene, usual);
            return QByteArray::number(qulonglong(record->size()));
        };
        m_works[QStringLiteral("why")] = [=] { return QJsonDocument(toJson(why(*scene, usual, 12, 10))).toJson(); };
        m_works[QStringLiteral("judgement")] = [=] {
            return QByteArray::number(qulonglong(judge(*scene, usual).wrong.size()));
        };
        m_works[QStringLiteral("npy")] = [] {
            const std::vector<float> values{1, 2, 3, 4};
            return npyBytes(std::span<const float>(values), 2, 2);
        };
    }

private Q_SLOTS:
    void initTestCase() { describeWorks(); }

    void everyAllocationFailsOnce_data()
    {
        QTest::addColumn<QString>("work");
        for (const auto& [name, work] : m_works)
            QTest::newRow(qPrintable(name)) << name;
    }

    /// In long works the steps between the allocations that fail grow; RASTERLENS_EVERY_ALLOCATION=1 has each of them
    /// fail.
    void everyAllocationFailsOnce()
    {
        QFETCH(QString, work);
        const auto run = m_works[work];
        const QByteArray expected = run();
        QVERIFY(!expected.isEmpty());
        int failures = 0;
        const long growth = qEnvironmentVariableIsSet("RASTERLENS_EVERY_ALLOCATION") ? 0 : 1;
        bool reached = true;
        for (long left = 0; reached; left += 1 + growth * left / 32) {
            QByteArray result;
            bool thrown = false;
            allocationsLeft = left;
            try {
                result = run();
            } catch (const std::bad_alloc&) {
                thrown = true;
            } catch (const std::system_error&) {
                thrown = true;
            }
            reached = allocationsLeft == kNever;
            allocationsLeft = kNever;
            failures += thrown ? 1 : 0;
            QVERIFY2(thrown || result == expected, qPrintable(QStringLiteral("allocation %1").arg(left)));
        }
        QVERIFY(failures > 0);
        QVERIFY(run() == expected);
    }
};

QTEST_GUILESS_MAIN(TestAllocations)
#include "test_allocations.moc"
