using Msisf.App.Preparation;
using Msisf.Core.Render.Photometry;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.Preparation;

public sealed class AlbedoSourceTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>The colour map of SVS 4720 has 415, 566, 643 and 689 nm; it is larger here, and the maps of one band are in two folders.</summary>
    [Theory]
    [InlineData(415, "WAC_EMP_415NM.IMG")]
    [InlineData(643, "moon_nasa_svs4720.jpg")]
    [InlineData(604, "WAC_EMP_604NM.IMG")]
    [InlineData(321, "moon_nasa_svs4720.jpg")] // none has it: the largest of the first folder, which is then refused
    public void Installed_MapsOfSeveralBands_IsOneOfTheBand(int band, string expected)
    {
        using TemporaryFolder second = new();
        string first = PdsMap.Write(_folder, "WAC_EMP_415NM", "PC_REAL", 32, 1, (_, _) => 0.1);
        PdsMap.Write(second, "WAC_EMP_604NM", "PC_REAL", 32, 1, (_, _) => 0.1);
        bool isLarger = band != 415;
        File.WriteAllBytes(_folder["moon_nasa_svs4720.jpg"], new byte[new FileInfo(first).Length + (isLarger ? 1 : -1)]);

        string? found = AlbedoSource.Installed([_folder.Path, second.Path, _folder["missing"]], SpectralBand.Of(band));

        Assert.Equal(expected, Path.GetFileName(found));
    }
}
