using Msisf.Adapters.Metadata;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Metadata;

/// <summary>The meta file as libxml2 sees it: in a folder far from lib/, valid by the grammar that it has in it.</summary>
public sealed class MetadataXmlTests : IDisposable
{
    private readonly DirectoryInfo _root = Directory.CreateTempSubdirectory("msisf-xml-");

    public void Dispose() => _root.Delete(recursive: true);

    [RequiresFact(Part.Xmllint)]
    public void Write_PublishedExample_IsValid() => AssertValid(ExampleFrame.OfSize(1024, 1024), spacing: 50);

    [RequiresFact(Part.Xmllint)]
    public void Write_ImageOfSpace_IsValid()
    {
        FrameMetadata frame = ExampleFrame.OfSize(64, 64);
        PinholeCamera away = new(new Vector3D(2e6, 2e6, 0.0), UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, Math.PI), 0.7, 64, 64);

        AssertValid(frame with { Camera = away }, spacing: 1);
    }

    [RequiresFact(Part.Xmllint)]
    public void Write_UndefinedDirection_IsValid()
    {
        FrameMetadata frame = ExampleFrame.OfSize(1, 1);
        PinholeCamera nadir = new(new Vector3D(4e6, 0.0, 0.0), UnitQuaternion.Identity, 0.1, 1, 1);

        AssertValid(frame with { Camera = nadir, SunPositionBodyFixed = new Vector3D(1e11, 0.0, 0.0) }, spacing: 1);
    }

    [RequiresTheory(Part.Xmllint)]
    [InlineData(RendererKind.PovRay)]
    [InlineData(RendererKind.Native)]
    public void Write_Terrain_IsValid(RendererKind renderer)
    {
        FrameMetadata frame = ExampleFrame.OfSize(1024, 1024) with { Renderer = renderer };

        AssertValid(frame, ExampleFrame.TerrainSampler(frame, spacing: 50));
    }

    [RequiresTheory(Part.Xmllint)]
    [InlineData("<Range unit=\"m\">", "<!-- ", "</Range>", " -->")] // all of the terrain's elements, or none
    [InlineData("state=\"shadow\"", "state=\"dark\"", "", "")]
    [InlineData("type=\"terrain\"", "type=\"sphere\"", "", "")]
    [InlineData("half=\"SW\"", "half=\"SE\"", "", "")]
    public void Xmllint_TerrainWithAnErrorInIt_IsInvalid(string text, string wrong, string end, string wrongEnd)
    {
        FrameMetadata frame = ExampleFrame.OfSize(1024, 1024);
        string path = WriteFiles(frame, ExampleFrame.TerrainSampler(frame, spacing: 50));
        string xml = File.ReadAllText(path);
        Assert.Contains(text, xml, StringComparison.Ordinal);
        xml = xml.Replace(text, wrong, StringComparison.Ordinal);
        File.WriteAllText(path, end.Length > 0 ? xml.Replace(end, wrongEnd, StringComparison.Ordinal) : xml);

        (int exitCode, _) = Xmllint("--valid", path);

        Assert.NotEqual(0, exitCode);
    }

    [RequiresFact(Part.Xmllint)]
    public void Xmllint_PixelAttributesAsInAppendixB2_AreInvalid()
    {
        // docs/deviations.md, row 16: the check above can fail.
        string path = WriteFiles(ExampleFrame.OfSize(1024, 1024), ExampleFrame.Sampler(ExampleFrame.OfSize(1024, 1024), spacing: 500));
        File.WriteAllText(path, File.ReadAllText(path).Replace("<Pixel h=", "<Pixel x=", StringComparison.Ordinal));

        (int exitCode, string errors) = Xmllint("--valid", path);

        Assert.NotEqual(0, exitCode);
        Assert.Contains("Pixel", errors, StringComparison.Ordinal);
    }

    private static (int ExitCode, string Errors) Xmllint(params string[] arguments)
    {
        ChildRun run = ChildRun.Of(TestParts.Program("xmllint")!, ["--noout", "--nonet", .. arguments], "/");
        return (run.ExitCode, run.Error);
    }

    private void AssertValid(FrameMetadata frame, int spacing) => AssertValid(frame, ExampleFrame.Sampler(frame, spacing));

    private void AssertValid(FrameMetadata frame, PixelSampler pixels)
    {
        string path = WriteFiles(frame, pixels);

        Assert.Equal((0, string.Empty), Xmllint("--valid", path));
        Assert.Equal(
            (0, string.Empty),
            Xmllint("--dtdvalid", new Uri(Path.Combine(TestParts.RepositoryRoot, "lib", "MSISRendering.dtd")).AbsoluteUri, path));
    }

    private string WriteFiles(FrameMetadata frame, PixelSampler pixels)
    {
        string path = Path.Combine(_root.CreateSubdirectory("output").FullName, "MoonSurfIllumSim_step_00001.xml");
        using FileStream stream = File.Create(path);
        MetadataXmlWriter.Write(stream, frame, pixels);
        return path;
    }
}
