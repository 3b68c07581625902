using Msisf.TestSupport;
using System.Text.RegularExpressions;
using Xunit;

namespace Msisf.Architecture.Tests;

/// <summary>The rules of the house that only the text of the sources shows.</summary>
public sealed partial class SourceRuleTests
{
    /// <summary>STYLE: a file has one purpose and stays under about 200 lines; past this it has two jobs.</summary>
    private const int LongestFile = 300;

    /// <summary>STYLE: a kernel that is one idea may have 600 lines.</summary>
    private const int LongestKernel = 600;

    /// <summary>As .editorconfig has it (max_line_length), which only editors keep.</summary>
    private const int LongestLine = 140;

    private static readonly string[] Sources = FilesUnder("src");

    private static readonly string[] Kernels = ["SubsampleBand.cs", "SubsampleCells.cs", "PixelParts.cs"];

    [Fact]
    public void Files_AreShort() =>
        Assert.All(Sources, path =>
        {
            int longest = Kernels.Contains(Path.GetFileName(path)) ? LongestKernel : LongestFile;
            Assert.True(File.ReadLines(path).Count() <= longest, $"{path} is longer than {longest} lines");
        });

    [Fact]
    public void Lines_AreShort() =>
        Assert.All(
            Sources.Concat(FilesUnder("tests")),
            path => Assert.DoesNotContain(File.ReadLines(path), line => line.Length > LongestLine));

    [Fact]
    public void Sources_HaveNoRegionsAndNoTodo() =>
        Assert.All(Sources, path => Assert.DoesNotMatch(RegionOrTodo(), File.ReadAllText(path)));

    /// <summary>
    /// With <see cref="HouseRuleTests.PrivateFields_AreNamedAsFields"/> the most of what the analysers of style say, which take as long as
    /// all else of the build; an editor has them, and <c>dotnet build -p:EnforceCodeStyleInBuild=true</c>.
    /// </summary>
    [Fact]
    public void Sources_HaveBracesAndNamespacesOfFilesAndNoThis() =>
        Assert.All(Sources, path =>
        {
            string text = File.ReadAllText(path);
            Assert.DoesNotMatch(NamespaceWithBraces(), text);
            Assert.DoesNotMatch(FieldWithThis(), text);
            Assert.DoesNotMatch(BranchWithoutBraces(), text);
        });

    /// <summary>Arguments pass without a shell, pipes are drained and children are ended in one place.</summary>
    [Fact]
    public void OtherPrograms_AreStarted_InOnePlaceOnly() =>
        Assert.Equal(
            ["src/Msisf.Adapters/Programs/ChildProgram.cs"],
            Sources.Where(path => File.ReadAllText(path).Contains("ProcessStartInfo", StringComparison.Ordinal))
                .Select(path => Path.GetRelativePath(TestParts.RepositoryRoot, path)));

    /// <summary>A moment is an Instant: doubles of MJD are read and printed, and never kept.</summary>
    [Fact]
    public void Mjd_IsADouble_AtInputAndOutputOnly() =>
        Assert.Equal(
            [
                "src/Msisf.Adapters/Input/TimeText.cs", "src/Msisf.App/Preparation/FrameNaming.cs", "src/Msisf.Core/Time/CalendarTime.cs",
                "src/Msisf.Core/Time/Instant.cs", "src/Msisf.Core/Time/TimeScale.cs", "src/Msisf.Server/FoldersEndpoint.cs",
                "src/Msisf.Server/SunEndpoints.cs",
            ],
            Sources.Where(path => DoubleOfMjd().IsMatch(File.ReadAllText(path)))
                .Select(path => Path.GetRelativePath(TestParts.RepositoryRoot, path)).Order(StringComparer.Ordinal));

    /// <summary>Tables, labels, messages, JSON, names of files; the noise of a frame, which is that of its printed time.</summary>
    [Fact]
    public void Mjd_OfAMoment_IsAskedForByOutputsOnly() =>
        Assert.Equal(
            [
                "src/Msisf.Adapters/CameraExport/Pds4Product.cs", "src/Msisf.Adapters/Input/TimeText.cs",
                "src/Msisf.Adapters/Layers/FitsProvenance.cs", "src/Msisf.Adapters/Layers/LayersJson.cs",
                "src/Msisf.Adapters/Metadata/AnnotationRenderer.cs", "src/Msisf.Adapters/Metadata/MetadataXmlWriter.cs",
                "src/Msisf.Adapters/Metadata/OriginXml.cs", "src/Msisf.App/DataSets/DataSetFile.cs",
                "src/Msisf.App/Illumination/IlluminationMaps.cs", "src/Msisf.App/Illumination/MonthOfLight.cs",
                "src/Msisf.App/Preparation/FrameNaming.cs", "src/Msisf.App/Preparation/PreparedRun.cs",
                "src/Msisf.Core/Detector/Noise/FrameNumber.cs", "src/Msisf.Core/Ephemeris/BlockTimes.cs",
                "src/Msisf.Core/Ephemeris/KernelCover.cs", "src/Msisf.Core/Scene/SpacecraftState.cs",
                "src/Msisf.Core/Time/Instant.cs", "src/Msisf.Core/Time/TimeInterval.cs", "src/Msisf.Server/FoldersEndpoint.cs",
                "src/Msisf.Server/SunEndpoints.cs",
            ],
            Sources.Where(path => File.ReadAllText(path).Contains(".Mjd", StringComparison.Ordinal))
                .Select(path => Path.GetRelativePath(TestParts.RepositoryRoot, path)).Order(StringComparer.Ordinal));

    /// <summary>Which exceptions say that the file system refuses is written in one place.</summary>
    [Fact]
    public void FileErrors_AreNamed_InOnePlaceOnly() =>
        Assert.Equal(
            ["src/Msisf.Core/Errors/FileErrors.cs"],
            Sources.Where(
                path => File.ReadAllText(path).Contains("is IOException or UnauthorizedAccessException", StringComparison.Ordinal))
                .Select(path => Path.GetRelativePath(TestParts.RepositoryRoot, path)));

    /// <summary>The crater profile's published fits are in km.</summary>
    [Fact]
    public void KilometresAppear_OnlyAtTheBorderToPovRayAndSpice() =>
        Assert.All(
            Sources.Where(path => !path.Contains("/Interop/", StringComparison.Ordinal)
                && !path.Contains("/Ephemeris/", StringComparison.Ordinal)
                && !path.EndsWith("PovSceneWriter.cs", StringComparison.Ordinal)
                && !path.EndsWith("CraterProfile.cs", StringComparison.Ordinal)),
            path => Assert.DoesNotMatch(KilometreName(), File.ReadAllText(path)));

    private static string[] FilesUnder(string folder) =>
    [
        .. Directory.EnumerateFiles(Path.Combine(TestParts.RepositoryRoot, folder), "*.cs", SearchOption.AllDirectories)
            .Where(path => !path.Contains("/obj/", StringComparison.Ordinal)),
    ];

    [GeneratedRegex(@"^\s*#region|\bTODO\b|\bFIXME\b|\bHACK\b", RegexOptions.Multiline)]
    private static partial Regex RegionOrTodo();

    [GeneratedRegex(@"^namespace [\w.]+\s*$", RegexOptions.Multiline)]
    private static partial Regex NamespaceWithBraces();

    [GeneratedRegex(@"\bthis\._")]
    private static partial Regex FieldWithThis();

    /// <summary>A statement on the line of its condition, or below it.</summary>
    [GeneratedRegex(@"^ *(else )?(if|for|foreach|while) \([^\n]*\)(\n? +[^ {.?:&|+\-*/=\n][^\n]*;| [^\n]*;)$", RegexOptions.Multiline)]
    private static partial Regex BranchWithoutBraces();

    [GeneratedRegex(@"\bdouble\??(\[\])? \w*[mM]jd\w*")]
    private static partial Regex DoubleOfMjd();

    [GeneratedRegex(@"\b[a-z]\w*Km\b")]
    private static partial Regex KilometreName();
}
