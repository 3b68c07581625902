using Msisf.Adapters.Catalogues;
using Msisf.Adapters.Metadata;
using Msisf.Core.Navigation;

namespace Msisf.Adapters.Navigation;

/// <summary>Writes the craters and the landmarks of a frame as CSV: a line each, with a heading.</summary>
public static class NavigationCsvWriter
{
    private static readonly string[] EllipseParameters = ["h", "v", "semiMajor", "semiMinor", "turn"];

    private static readonly CraterView NoCrater =
        new(new Crater(1, "1", null, 0.0, 0.0, 1.0), default, default) { Inside = 0.0, Emission = 0.0, Incidence = 0.0 };

    private static readonly LandmarkView NoLandmark = new(new Landmark(1, "1", null, default, null), default, 0.0, 0.0)
    {
        IsLit = false,
        Range = 0.0,
        PixelScale = 0.0,
        Derivatives = default,
    };

    /// <summary>Writes the craters.</summary>
    /// <param name="writer">Receives the text.</param>
    /// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
    public static void Write(TextWriter writer, CratersOfFrame craters, double referenceRadius)
    {
        bool hasErrors = craters.Views.Any(view => view.Crater.Errors is not null);
        IEnumerable<string> names = CraterFields.Of(NoCrater, referenceRadius).Select(field => field.Name);
        WriteHead(writer, [.. names, .. hasErrors ? CovarianceNames() : []]);
        foreach (CraterView view in craters.Views)
        {
            WriteLine(
                writer, view.Crater.Number, view.Crater.Identity, view.Crater.Name,
                [
                    .. CraterFields.Of(view, referenceRadius).Select(field => CraterFields.TextOf(field.Value)),
                    .. hasErrors ? Covariances(view) : [],
                ]);
        }
    }

    /// <summary>Writes the landmarks. A vector is three numbers with blanks between.</summary>
    /// <param name="writer">Receives the text.</param>
    /// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
    public static void Write(TextWriter writer, LandmarksOfFrame landmarks, double referenceRadius)
    {
        WriteHead(writer, LandmarkFields.Of(NoLandmark, referenceRadius).Select(field => field.Name));
        foreach (LandmarkView view in landmarks.Views)
        {
            IEnumerable<string> fields = LandmarkFields.Of(view, referenceRadius).Select(field => field.Value);
            WriteLine(writer, view.Landmark.Number, view.Landmark.Identity, view.Landmark.Name, fields);
        }
    }

    private static void WriteHead(TextWriter writer, IEnumerable<string> names) =>
        writer.Write($"number,id,name,{string.Join(',', names)}\n");

    private static void WriteLine(TextWriter writer, int number, string identity, string? name, IEnumerable<string> fields) =>
        writer.Write(Invariant($"{number},{CsvLine.Field(identity)},{CsvLine.Field(name ?? string.Empty)},{string.Join(',', fields)}\n"));

    /// <summary>The upper triangle by rows: cov_h_h, cov_h_v, ...</summary>
    private static IEnumerable<string> CovarianceNames() => Triangle().Select(
        place => $"cov_{EllipseParameters[place / EllipseParameters.Length]}_{EllipseParameters[place % EllipseParameters.Length]}");

    private static IEnumerable<string> Covariances(CraterView view)
    {
        double[]? covariance = CraterFields.CovarianceOf(view);
        return Triangle().Select(place => CraterFields.TextOf(covariance?[place]));
    }

    private static IEnumerable<int> Triangle() =>
        from row in Enumerable.Range(0, EllipseParameters.Length)
        from column in Enumerable.Range(row, EllipseParameters.Length - row)
        select (row * EllipseParameters.Length) + column;
}
