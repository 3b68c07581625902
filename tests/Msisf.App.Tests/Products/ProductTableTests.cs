using Msisf.App.Products;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.App.Tests.Settings;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.Products;

/// <summary>The table of products: names of files, refusals, and the table of docs/formats.md; MSISF_WRITE_DOCS=1 writes that.</summary>
public sealed class ProductTableTests
{
    private const string Begin = "<!-- products: begin (written by the test ProductTableTests with MSISF_WRITE_DOCS=1) -->\n";
    private const string End = "<!-- products: end -->\n";
    private const string LargeScan = "--renderer native --camera lroc-nac-l --lines 1700 ";

    [Theory]
    [InlineData("m.png", "m")]
    [InlineData("m.xml", "m")]
    [InlineData("m.pov", "m")]
    [InlineData("m.fits", "m")]
    [InlineData("m.layers.json", "m")]
    [InlineData("m.sun-visibility.npy", "m")]
    [InlineData("m.sensitivity.d-albedo.npy", "m")]
    [InlineData("m.depth.map.tif", "m,m.depth")]
    [InlineData("m.annotated.png", "m,m.annotated")] // also the image of a frame "m.annotated"
    [InlineData("m.txt", "")]
    [InlineData("m.npy", "")]
    [InlineData("m", "")]
    public void FramesOf_Name_IsThatBeforeTheEnding(string file, string frames)
    {
        string[] expected = frames.Split(',', StringSplitOptions.RemoveEmptyEntries);

        Assert.Equal(expected, ProductTable.FramesOf(file).Order(StringComparer.Ordinal));
        Assert.All(expected, frame => Assert.Contains(file, ProductTable.NamesOf(frame)));
    }

    [Fact]
    public void NamesAndEndings_AreEachOfOneProduct()
    {
        string[] endings = [.. ProductTable.All.SelectMany(product => product.Files).SelectMany(file => file.Endings)];

        Assert.Equal(endings.Distinct(), endings);
        Assert.Equal(ProductTable.All.Count, ProductTable.All.Select(product => product.Name).Distinct().Count());
    }

    [Theory]
    [InlineData("--rendering-annotation", "--rendering-annotation")]
    [InlineData("--earth --stars bright", "--stars")]
    [InlineData("--map orthographic,100", "--map")]
    [InlineData("--camera-model csm,pds4", "--camera-model pds4")]
    public void RefuseInStrips_ProductOfTheWholeImage_IsNamed(string options, string name)
    {
        UsageException exception = Assert.Throws<UsageException>(() => ProductTable.RefuseInStrips(Settings(LargeScan + options)));

        Assert.Contains($"px is drawn in strips, and {name} needs more of it at once", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void RefuseInStrips_ProductsOfRows_AreNot() =>
        ProductTable.RefuseInStrips(Settings(LargeScan + "--layers depth --camera-model csm --surface terrain"));

    [Fact]
    public void FormatsPage_HasTheTable()
    {
        string path = Path.Combine(TestParts.RepositoryRoot, "docs", "formats.md");
        string page = File.ReadAllText(path);
        int begin = page.IndexOf(Begin, StringComparison.Ordinal) + Begin.Length;
        int end = page.IndexOf(End, StringComparison.Ordinal);
        Assert.True(begin >= Begin.Length && end >= begin, "docs/formats.md lacks the marks of its table");
        string table = "| file | content |\n|---|---|\n" + string.Concat(ProductTable.All.SelectMany(product => product.Files).Select(Row));
        if (Environment.GetEnvironmentVariable("MSISF_WRITE_DOCS") == "1")
        {
            File.WriteAllText(path, page[..begin] + table + page[end..]);
            return;
        }

        Assert.Equal(table, page[begin..end]);
    }

    private static string Row(ProductFile file)
    {
        string names = file.Shown ?? string.Join(", ", file.Endings.Select(ending => $"`{ending}`"));
        string options = string.Join(", ", file.Options.Select(option => $"`{option.Name}`"));
        return $"| {names} | {(options.Length == 0 ? string.Empty : $"with {options}: ")}{file.Content} |\n";
    }

    private static RenderSettings Settings(string options) => RenderSettingsReader.Read(Given.Options(options));
}
