using System.Text.Json;
using Msisf.Adapters.IO;
using Msisf.Adapters.Manifest;
using Msisf.Adapters.Navigation;
using Msisf.Adapters.States;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Scene;

namespace Msisf.App.DataSets;

/// <summary>Writes the index of a data set: all images in CSV, and each split in the formats that are wished.</summary>
internal sealed class DataSetIndex(IReadOnlyList<DataSetImage> images, CameraModel camera, CocoSource source)
{
    public const string CsvName = "index.csv";

    private static readonly Quantity[] Drawn =
        [Quantity.Altitude, Quantity.OffNadir, Quantity.Azimuth, Quantity.Roll, Quantity.Exposure, Quantity.Shift, Quantity.Turn];

    public void WriteCsv(TextWriter writer)
    {
        writer.WriteLine(string.Join(
            ',',
            [
                "number", "file", "split", "candidate", "latitude", "longitude", "sun_elevation", "sun_azimuth", "ground", "lit",
                .. Drawn.Select(quantity => quantity.Key.Replace('-', '_')), "mjd", "x", "y", "z", "qx", "qy", "qz", "q0", "sun_x", "sun_y",
                "sun_z", "sha256",
            ]));
        foreach (DataSetImage image in images)
        {
            DrawnState drawn = image.Drawn;
            Vector3D? sun = drawn.State.SunPositionBodyFixed;
            double?[] numbers =
            [
                double.RadiansToDegrees(drawn.Place.Latitude), double.RadiansToDegrees(drawn.Place.Longitude),
                double.RadiansToDegrees(drawn.Sun.Elevation), drawn.Sun.Azimuth is { } azimuth ? double.RadiansToDegrees(azimuth) : null,
                drawn.Ground, drawn.Lit,
                .. Drawn.Select(quantity => drawn.Drawn.TryGetValue(quantity, out double value) ? value : (double?)null),
                .. drawn.State.ToNumbers().Select(number => (double?)number), sun?.X, sun?.Y, sun?.Z,
            ];
            writer.WriteLine(string.Join(
                ',',
                [
                    Text(image.Number), image.FileName, drawn.Split, drawn.Candidate.ToString(CultureInfo.InvariantCulture),
                    .. numbers.Select(number => number is { } value ? NumberSpec.TextOf(value) : string.Empty), image.Files[0].Sha256,
                ]));
        }
    }

    /// <param name="files">Receives the files.</param>
    /// <param name="split">Name of the split.</param>
    /// <param name="format">coco, tum or kitti.</param>
    public IReadOnlyList<string> Write(AtomicFileSet files, string folder, string split, string format)
    {
        DataSetImage[] own = [.. images.Where(image => image.Drawn.Split == split)];
        List<string> paths = [];
        switch (format)
        {
            case "coco":
                string path = Path.Combine(folder, $"{split}.coco.json");
                files.Write(path, stream => WriteCoco(stream, own, folder));
                paths.Add(path);
                break;
            case "tum":
                Put("rgb.txt", writer => WriteList(
                    writer, ["# timestamp filename: the number of the image; its file"],
                    own.Select(image => $"{StateTables.TimestampOf(image.Number)} {image.FileName}")));
                Put("groundtruth.txt", writer => StateTables.WriteTum(
                    writer, [.. own.Select(image => image.Drawn.State)], [.. own.Select(image => image.Number)]));
                break;
            default:
                Put("poses.txt", writer => WriteList(writer, [], own.Select(image => PoseOf(image.Drawn.State))));
                Put("times.txt", writer => WriteList(writer, [], own.Select(image => Text(image.Number))));
                Put("images.txt", writer => WriteList(writer, [], own.Select(image => image.FileName)));
                string matrix = Joined(
                    camera.FocalX, camera.Skew, camera.PrincipalX - 1.0, 0.0, 0.0, camera.FocalY, camera.PrincipalY - 1.0, 0.0, 0.0, 0.0,
                    1.0, 0.0);
                Put("calib.txt", writer => WriteList(writer, [], [$"P0: {matrix}"]));
                break;
        }

        return paths;

        void Put(string ending, Action<TextWriter> write)
        {
            string path = Path.Combine(folder, $"{split}.{ending}");
            files.WriteText(path, write);
            paths.Add(path);
        }
    }

    private static void WriteList(TextWriter writer, IEnumerable<string> head, IEnumerable<string> lines)
    {
        foreach (string line in head.Concat(lines))
        {
            writer.WriteLine(line);
        }
    }

    /// <summary>The first three rows of the matrix from the camera's axes (x right, y down, z forward) into MOON_ME.</summary>
    private string PoseOf(SpacecraftState state)
    {
        CameraMatrix matrix = CameraMatrix.Of(camera.At(new CameraState(state.PositionBodyFixed, state.MoonFromCamera)));
        (Vector3D right, Vector3D down, Vector3D forward) = (matrix.RotationRows[0], matrix.RotationRows[1], matrix.RotationRows[2]);
        Vector3D place = state.PositionBodyFixed;
        return Joined(
            right.X, down.X, forward.X, place.X, right.Y, down.Y, forward.Y, place.Y, right.Z, down.Z, forward.Z, place.Z);
    }

    private static string Joined(params double[] numbers) => string.Join(' ', numbers.Select(NumberSpec.TextOf));

    private static string Text(int number) => number.ToString(CultureInfo.InvariantCulture);

    /// <summary>The craters of all images of a split: those of the images' own files, with numbers of their own.</summary>
    private void WriteCoco(Stream stream, DataSetImage[] own, string folder)
    {
        using Utf8JsonWriter json = new(stream);
        json.WriteStartObject();
        CocoWriter.WriteHead(
            json, source, (camera.Width, camera.Height),
            [.. own.Select(image => new CocoImage(image.Number, image.FileName, image.Drawn.State.Time))]);
        int number = 0;
        json.WriteStartArray("annotations");
        foreach (DataSetImage image in own)
        {
            JsonElement craters = JsonElement.Parse(File.ReadAllBytes(image.PathOf(folder, ".craters.json")!));
            foreach (JsonElement annotation in craters.GetProperty("annotations").EnumerateArray())
            {
                json.WriteStartObject();
                json.WriteNumber("id", ++number);
                foreach (JsonProperty property in annotation.EnumerateObject().Where(property => property.Name != "id"))
                {
                    property.WriteTo(json);
                }

                json.WriteEndObject();
            }
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }
}

/// <summary>An image of a data set that is there.</summary>
/// <param name="Number">From 1.</param>
/// <param name="Files">Its files, the image first.</param>
internal sealed record DataSetImage(int Number, DrawnState Drawn, IReadOnlyList<OutputFile> Files)
{
    public string FileName => Files[0].Name;

    /// <param name="ending">E.g. ".craters.csv".</param>
    public string? PathOf(string folder, string ending) =>
        Files.FirstOrDefault(file => file.Name == Path.GetFileNameWithoutExtension(FileName) + ending) is { } found
            ? Path.Combine(folder, found.Name)
            : null;
}
