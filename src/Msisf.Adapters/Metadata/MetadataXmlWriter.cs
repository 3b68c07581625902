using System.Text;
using Msisf.Core.Metadata;

namespace Msisf.Adapters.Metadata;

/// <summary>
/// Writes a frame's meta file as thesis section 9.2 shows it (docs/formats.md): UTF-8 without BOM, LF, with lib/MSISRendering.dtd in it,
/// so that it is valid wherever it lies.
/// </summary>
public static class MetadataXmlWriter
{
    /// <summary>Below this many grid points, starting threads costs more than it gains.</summary>
    private const int MinPixelsInParallel = 4096;

    /// <summary>Version of the format (lib/MSISRendering.dtd).</summary>
    private const int FormatVersion = 3;

    /// <summary>Writes the elements of one file without its pixels.</summary>
    /// <param name="stream">Receives the file; stays open.</param>
    /// <param name="frame">What holds for the whole frame.</param>
    /// <param name="pixels">Their grid and surface.</param>
    /// <param name="digits">Digits of the numbers.</param>
    public static void WriteFrame(Stream stream, FrameMetadata frame, PixelSampler pixels, LongEDigits digits)
    {
        stream.Write(Encoding.UTF8.GetBytes(GeneralInformation(frame, pixels, digits)));
        WriteEnd(stream, frame);
    }

    /// <summary>Writes one file. The bytes depend on the arguments alone, not on the number of cores.</summary>
    /// <param name="stream">Receives the file; stays open.</param>
    /// <param name="frame">What holds for the whole frame.</param>
    /// <param name="pixels">Gives the pixels, by rows from the top; its surface decides what the file tells of them.</param>
    /// <param name="digits">Digits of the numbers; those of a meta file are the thesis's.</param>
    /// <param name="cancellation">Stops between rows.</param>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public static void Write(
        Stream stream, FrameMetadata frame, PixelSampler pixels, LongEDigits digits = LongEDigits.Thesis,
        CancellationToken cancellation = default)
    {
        stream.Write(Encoding.UTF8.GetBytes(Grammar(frame)));
        stream.Write(Encoding.UTF8.GetBytes(GeneralInformation(frame, pixels, digits)));
        WritePixels(stream, pixels, digits, cancellation);
        WriteEnd(stream, frame);
    }

    private static void WriteEnd(Stream stream, FrameMetadata frame)
    {
        stream.Write("  </PixelInformation>\n"u8);
        if (frame.Navigation is { } navigation)
        {
            stream.Write(Encoding.UTF8.GetBytes(NavigationXml.Elements(navigation, frame.Globe.ReferenceRadius)));
        }

        if (frame.Stars is { } stars)
        {
            stream.Write(Encoding.UTF8.GetBytes(SkyXml.Elements(stars)));
        }

        if (frame.Bodies is { } bodies)
        {
            stream.Write(Encoding.UTF8.GetBytes(SkyXml.Elements(bodies)));
        }

        stream.Write("</MSISRendering>\n"u8);
    }

    private static void WritePixels(Stream stream, PixelSampler pixels, LongEDigits digits, CancellationToken cancellation)
    {
        bool parallel = (long)pixels.Grid.Rows * pixels.Grid.Columns >= MinPixelsInParallel;
        int workers = parallel ? Environment.ProcessorCount : 1;
        ParallelOptions options = new() { MaxDegreeOfParallelism = workers, CancellationToken = cancellation };
        RowBuffer[] buffers = [.. Enumerable.Range(0, Math.Min(workers, pixels.Grid.Rows)).Select(_ => new RowBuffer(pixels, digits))];
        for (int firstRow = 0; firstRow < pixels.Grid.Rows; firstRow += buffers.Length)
        {
            int rows = Math.Min(buffers.Length, pixels.Grid.Rows - firstRow);
            Parallel.For(0, rows, options, i => buffers[i].Fill(firstRow + i));
            foreach (RowBuffer buffer in buffers.AsSpan(0, rows))
            {
                stream.Write(buffer.Bytes);
            }
        }
    }

    private static string Grammar(FrameMetadata frame) => $"""
        <?xml version="1.0" encoding="UTF-8" standalone="no" ?>
        <!DOCTYPE MSISRendering [
        {MetaFileGrammar.Text(frame.Navigation is not null, frame.Scan is not null, frame.Rig is not null, HasSky(frame))}
        ]>

        """;

    private static bool HasSky(FrameMetadata frame) => frame.Stars is not null || frame.Bodies is not null;

    private static string GeneralInformation(FrameMetadata frame, PixelSampler pixels, LongEDigits digits) => Invariant($"""
        <MSISRendering>
          <GeneralInformation>
            <SimulationTime>
              <MJD>{LongE.ToText(frame.SimulationTime.Mjd, digits)}</MJD>
              <UTC>{frame.SimulationTime.ToIsoUtc()}</UTC>
            </SimulationTime>
            <CameraPosition unit="m">
              {VectorXml.Of(frame.Camera.PositionBodyFixed, digits)}
            </CameraPosition>
            <CameraOrientation>
              {VectorXml.Of(frame.Camera.MoonFromCamera, digits)}
            </CameraOrientation>
            <SunPosition unit="m">
              {VectorXml.Of(frame.SunPositionBodyFixed, digits)}
            </SunPosition>
            <FlightAltitude unit="m">{LongE.ToText(frame.FlightAltitude, digits)}</FlightAltitude>
            <SurfaceResolution unit="{frame.Elevation.Resolution.Unit}">{frame.Elevation.Resolution.NumberText}</SurfaceResolution>
            <FOV unit="deg">{frame.FieldOfViewDegrees:R}</FOV>
            <MSISVersion>{XmlText.Escape(frame.Version)}</MSISVersion>
            <CommandLine>{XmlText.Escape(frame.CommandLine)}</CommandLine>{SurfaceLine(pixels.Surface, frame)}
            <FormatVersion>{FormatVersion}</FormatVersion>
            <HeightOverTerrain unit="m">{LongE.ToText(frame.HeightOverTerrain, digits)}</HeightOverTerrain>
        {OriginXml.Lines(frame, digits)}{ScanXml.Lines(frame, pixels.Grid, digits)}{RigXml.Lines(frame.Rig, digits)}
          </GeneralInformation>
          <PixelInformation>

        """);

    private static string SurfaceLine(PixelSurface surface, FrameMetadata frame) => surface == PixelSurface.Terrain
        ? Invariant($"\n    <PixelSurface type=\"terrain\" renderer=\"{frame.RendererName}\" formatVersion=\"{FormatVersion}\" />")
        : string.Empty;

    /// <summary>The memory of one worker: a row's records and their text.</summary>
    private sealed class RowBuffer(PixelSampler pixels, LongEDigits digits)
    {
        private readonly PixelRecord[] _records = new PixelRecord[pixels.Grid.Columns];
        private readonly byte[] _text = new byte[pixels.Grid.Columns * PixelXml.MaximumLength(pixels.Surface)];
        private int _length;

        public ReadOnlySpan<byte> Bytes => _text.AsSpan(0, _length);

        public void Fill(int row)
        {
            int count = pixels.SampleRow(row, _records);
            _length = 0;
            foreach (ref readonly PixelRecord record in _records.AsSpan(0, count))
            {
                _length += PixelXml.Write(record, _text.AsSpan(_length), digits);
            }
        }
    }
}

/// <summary>The elements of a meta file that hold a vector or a rotation.</summary>
internal static class VectorXml
{
    public static string Of(Vector3D v, LongEDigits digits) =>
        $"""<Vector3D x="{LongE.ToText(v.X, digits)}" y="{LongE.ToText(v.Y, digits)}" z="{LongE.ToText(v.Z, digits)}" />""";

    /// <summary>A rotation, the real part first.</summary>
    public static string Of(UnitQuaternion q, LongEDigits digits) =>
        $"<Quaternion r=\"{LongE.ToText(q.W, digits)}\" x=\"{LongE.ToText(q.X, digits)}\" "
            + $"y=\"{LongE.ToText(q.Y, digits)}\" z=\"{LongE.ToText(q.Z, digits)}\" />";
}
