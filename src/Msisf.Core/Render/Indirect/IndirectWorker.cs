using Msisf.Core.Camera;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Indirect;

/// <summary>How the points of a frame are sampled.</summary>
/// <param name="Points">The points.</param>
/// <param name="Options">The settings.</param>
/// <param name="Rows">Rows of a strip, which is divided into groups from left to right.</param>
/// <param name="Columns">Columns of a group.</param>
/// <param name="Groups">Groups of a strip.</param>
/// <param name="Number">Tells rounds apart.</param>
/// <param name="Effort">How many samples the groups take (<see cref="Trial.Next"/>); 0 in the first round.</param>
internal sealed record Round(
    ISurfaceRows Points, NativeRenderOptions Options, int Rows, int Columns, int Groups, long Number, double Effort);

/// <summary>Samples the groups of a strip of points; the buffers of one thread.</summary>
/// <param name="surface">The surface.</param>
/// <param name="gather">Samples a group.</param>
internal sealed class IndirectWorker(SurfaceModel surface, LightGather gather)
{
    private readonly GatheredLight _light = new(isIrradiance: false);
    private readonly List<SurfaceRow> _rows = [];
    private readonly int[] _next = new int[Receivers.Size];
    private readonly int[] _places = new int[Receivers.Size];

    /// <summary>Reflection on the points.</summary>
    public RowReflection Reflection { get; } = new(surface);

    /// <summary>Samples a group.</summary>
    public LightGather Gather => gather;

    /// <summary>Reads the rows of a strip.</summary>
    public void Read(Round round, int strip)
    {
        Array.Clear(_next);
        for (int row = 0; row < round.Rows; row++)
        {
            RowAt(row).Count = 0;
            if ((strip * round.Rows) + row < round.Points.Height)
            {
                round.Points.Read((strip * round.Rows) + row + 1, RowAt(row));
            }
        }
    }

    /// <summary>Takes the points of the next group of the strip; false if there are none.</summary>
    /// <param name="camera">m, body-fixed.</param>
    /// <param name="reach">m: nearer ground is looked at by rays.</param>
    /// <param name="shared">What pixels of the image see that lie far apart.</param>
    public bool TryFill(Round round, int strip, int group, Vector3D camera, double reach, SharedSight shared)
    {
        Receivers receivers = gather.Group;
        receivers.Clear();
        int end = (group + 1) * round.Columns;
        for (int row = 0; row < round.Rows; row++)
        {
            SurfaceRow pixels = _rows[row];
            int y = (strip * round.Rows) + row;
            for (; _next[row] < pixels.Count && pixels.Columns[_next[row]] < end; _next[row]++)
            {
                int i = _next[row];
                if (pixels.Columns[i] < end - round.Columns)
                {
                    continue; // of a group that needs no samples
                }

                Vector3D point = new(pixels.X[i], pixels.Y[i], pixels.Z[i]);
                Vector3D facet = new(pixels.NormalX[i], pixels.NormalY[i], pixels.NormalZ[i]);
                Vector3D normal = round.Options.Normals == NormalModel.Facet
                    ? facet
                    : Reflection.Smooth(round.Points.FacetOf(y + 1, pixels.Facets[i]), facet, point, camera);
                int place = (y * round.Points.Width) + pixels.Columns[i];
                _places[receivers.Count] = place;
                receivers.Add(point, facet, normal, (camera - point).Normalized(), reach, place);
            }
        }

        if (receivers.Count > 0)
        {
            gather.Begin(shared);
        }

        return receivers.Count > 0;
    }

    /// <summary>Finds the light of far ground on the points of the group, as if they saw what the pixels around them see.</summary>
    /// <param name="samples">How many points of the ground count.</param>
    /// <param name="round">Tells rounds apart.</param>
    /// <param name="values">Receives the light.</param>
    /// <returns>The light, with the squares of its errors.</returns>
    public GatheredLight FindShared(int samples, long round, double[] values)
    {
        _light.Clear();
        gather.Far.AddShared(samples, round, _light);
        return Spread(values);
    }

    /// <summary>Finds what they see otherwise; the parameters are those of <see cref="FindShared"/>.</summary>
    public GatheredLight FindOther(int samples, long round, double[] values)
    {
        _light.Clear();
        gather.Far.AddOther(samples, round, _light);
        return Spread(values);
    }

    /// <summary>Finds the light of near ground on them; other parameters are those of <see cref="FindShared"/>.</summary>
    /// <param name="samples">How many rays each point has.</param>
    /// <param name="top">rad: how far up near ground was found; 0 if that is not known.</param>
    /// <param name="round">Tells rounds apart.</param>
    /// <param name="values">Receives the light.</param>
    public GatheredLight FindNear(int samples, double top, long round, double[] values)
    {
        _light.Clear();
        gather.AddNear(samples, top, round, _light);
        return Spread(values);
    }

    private GatheredLight Spread(double[] values)
    {
        for (int i = 0; i < gather.Group.Count; i++)
        {
            values[_places[i]] = _light.Values[i];
        }

        return _light;
    }

    /// <summary>Finds by what the map scales the points of a row.</summary>
    public void Scale(ISurfaceRows points, int row, FrameCamera camera, NativeRenderOptions options)
    {
        SurfaceRow pixels = RowAt(0);
        points.Read(row + 1, pixels);
        Reflection.Points.Clear(points.Width);
        for (int i = 0; i < pixels.Count; i++)
        {
            Vector3D normal = new(pixels.NormalX[i], pixels.NormalY[i], pixels.NormalZ[i]);
            Reflection.Points.Add(pixels.Columns[i], 1.0, new Vector3D(pixels.X[i], pixels.Y[i], pixels.Z[i]), normal, 1.0);
        }

        Reflection.FindScales(camera, options);
    }

    private SurfaceRow RowAt(int index)
    {
        while (_rows.Count <= index)
        {
            _rows.Add(new SurfaceRow());
        }

        return _rows[index];
    }
}
