using Msisf.Adapters.IO;
using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Synthesis;
using Msisf.Core.Terrain;

namespace Msisf.Benchmarks.Programs;

/// <summary>
/// Makes a whole Moon of a synthetic model's part: the ground around it is the reference sphere, in sparse files that take no room. A
/// model of 512 px/deg has 34 GB, and the scenes show a fortieth of it.
/// </summary>
internal static class FlatGround
{
    /// <summary>Writes the images and labels of the rest beside those of the part; what is there stays.</summary>
    /// <param name="labelPath">The part's label.</param>
    public static void Fill(string labelPath)
    {
        LdemLabel label = LdemLabelReader.ReadFile(labelPath);
        string folder = Path.GetDirectoryName(Path.GetFullPath(labelPath))!;
        MoonRegion part = new((int)label.SouthDegrees, (int)label.NorthDegrees, (int)label.WestDegrees, (int)label.EastDegrees);
        MoonRegion[] rest =
        [
            new(part.NorthDegrees, 90, 0, 360),
            part with { WestDegrees = 0, EastDegrees = part.WestDegrees },
            part with { WestDegrees = part.EastDegrees, EastDegrees = 360 },
            new(-90, part.SouthDegrees, 0, 360),
        ];
        foreach (MoonRegion region in rest.Where(region => region.IsValid))
        {
            Write(new SyntheticLdemOptions(label.PixelsPerDegree, Seed: 0, folder)
            {
                Region = region,
                Rest = SyntheticRest.None,
                Format = SyntheticSampleFormat.Integers,
            });
        }
    }

    private static void Write(SyntheticLdemOptions product)
    {
        string stem = Path.Combine(product.OutputFolder, product.ProductId);
        using (FileStream image = new($"{stem}.IMG", FileMode.OpenOrCreate, FileAccess.Write))
        {
            image.SetLength(product.Bytes); // zeros that the file system does not store: height 0
        }

        AtomicFile.WriteText($"{stem}.LBL", writer => SyntheticLdemLabel.Of(product).Write(writer, minimum: 0, maximum: 0));
    }
}
